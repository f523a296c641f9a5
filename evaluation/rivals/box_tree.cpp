#include "evaluation/rivals/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pelt::rivals {

namespace {

constexpr int kMaxBins = 12;

/// A triangle's box; `first` is the triangle's number.
using Item = NumberedBox;

float middle(const Item& item, int axis) { return item.low[axis] + item.high[axis]; }

struct Bin {
  Box4 box = detail::empty_box();
  std::uint32_t count = 0;
};

/// Bins of equal width between the lowest and the highest middle of a set of boxes.
class Binning {
 public:
  Binning(float low, float high, int bins)
      : low_(low), scale_(static_cast<float>(bins) / (high - low)), last_(bins - 1) {}

  /// Whether the boxes have different middles.
  bool is_sound() const { return std::isfinite(scale_); }

  int bin_of(float middle) const {
    return std::min(static_cast<int>((middle - low_) * scale_), last_);
  }

 private:
  float low_, scale_;
  int last_;
};

struct Cut {
  int axis = 0;
  int bin = 0;  // the first on the right
  double cost = HUGE_VAL;
};

void improve(Cut& best, int axis, std::span<const Bin> bins) {
  std::array<double, kMaxBins> right_cost;
  Bin right, left;
  for (std::size_t i = bins.size(); --i > 0;) {
    right = {unite(right.box, bins[i].box), right.count + bins[i].count};
    right_cost[i] = right.count == 0 ? HUGE_VAL : half_area(right.box) * right.count;
  }
  for (std::size_t i = 1; i < bins.size(); ++i) {
    left = {unite(left.box, bins[i - 1].box), left.count + bins[i - 1].count};
    if (left.count == 0) continue;
    const double cost = half_area(left.box) * left.count + right_cost[i];
    if (cost < best.cost) best = {axis, static_cast<int>(i), cost};
  }
}

class Builder {
 public:
  Builder(std::span<const Triangle> triangles, const Points& points, std::uint32_t leaf_triangles)
      : leaf_triangles_(leaf_triangles), items_(triangles.size()) {
    for (std::uint32_t t = 0; t < items_.size(); ++t) {
      items_[t] = {{}, t, {}, 0};
      items_[t].set_box(points.box_of(triangles[t]));
    }
  }

  BoxTree build() && {
    tree_.nodes.reserve(items_.size());
    add_leaf(0, static_cast<std::uint32_t>(items_.size()));
    for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
      if (tree_.nodes[n].count > leaf_triangles_) split(n);
    for (const Item& item : items_) tree_.order.push_back(item.first);
    return std::move(tree_);
  }

 private:
  void add_leaf(std::uint32_t first, std::uint32_t count) {
    Box4 box = detail::empty_box();
    for (std::uint32_t i = first; i < first + count; ++i) box = unite(box, items_[i].box());
    tree_.nodes.push_back({{}, first, {}, count});
    tree_.nodes.back().set_box(box);
  }

  void split(std::uint32_t n) {
    const std::uint32_t first = tree_.nodes[n].first, count = tree_.nodes[n].count;
    const std::uint32_t left = partition({items_.data() + first, count});
    tree_.nodes[n].first = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes[n].count = 0;
    add_leaf(first, left);
    add_leaf(first + left, count - left);
  }

  /// Moves the boxes of the left child to the front and returns their number; half of them if their
  /// middles coincide.
  std::uint32_t partition(std::span<Item> items) {
    Box4 middles = detail::empty_box();
    for (const Item& item : items) {
      const Box4 box = item.box();
      const Float4 m = box.low + box.high;
      middles = {min(middles.low, m), max(middles.high, m)};
    }
    // Evaluating many bins for few boxes would cost more than it gains.
    const int bin_count = std::clamp(static_cast<int>(items.size() / 2), 4, kMaxBins);
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
      const Binning binning(middles.low[axis], middles.high[axis], bin_count);
      if (!binning.is_sound()) continue;
      std::array<Bin, kMaxBins> bins;
      for (const Item& item : items) {
        Bin& bin = bins[binning.bin_of(middle(item, axis))];
        bin = {unite(bin.box, item.box()), bin.count + 1};
      }
      improve(best, axis, {bins.data(), static_cast<std::size_t>(bin_count)});
    }
    if (best.cost == HUGE_VAL) return static_cast<std::uint32_t>(items.size() / 2);
    const Binning binning(middles.low[best.axis], middles.high[best.axis], bin_count);
    const auto right = std::partition(items.begin(), items.end(), [&](const Item& item) {
      return binning.bin_of(middle(item, best.axis)) < best.bin;
    });
    return static_cast<std::uint32_t>(right - items.begin());
  }

  std::uint32_t leaf_triangles_;
  std::vector<Item> items_;
  BoxTree tree_;
};

}  // namespace

BoxTree build_box_tree(std::span<const Triangle> triangles, const Points& points,
                       std::uint32_t leaf_triangles) {
  return Builder(triangles, points, leaf_triangles).build();
}

namespace {

/// The list of the vertices of a set of triangles.
std::vector<std::uint32_t> corners_of(std::span<const Triangle> all,
                                      std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t t : triangles)
    corners.insert(corners.end(), all[t].begin(), all[t].end());
  make_vertex_list(corners);
  return corners;
}

/// The leaves, ordered by their triangles.
std::vector<std::uint32_t> leaves_of(const BoxTree& tree) {
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    if (tree.nodes[n].count > 0) leaves.push_back(n);
  std::sort(leaves.begin(), leaves.end(), [&](std::uint32_t a, std::uint32_t b) {
    return tree.nodes[a].first < tree.nodes[b].first;
  });
  return leaves;
}

}  // namespace

TreeShape::TreeShape(std::span<const Triangle> triangles, std::span<const Vec3> rest,
                     std::uint32_t leaf_triangles)
    : tree(build_box_tree(triangles, Points(rest), leaf_triangles)),
      vertices_of(tree.nodes.size()) {
  for (const std::uint32_t n : leaves_of(tree)) {
    const BoxNode& leaf = tree.nodes[n];
    const auto corners = corners_of(triangles, {tree.order.data() + leaf.first, leaf.count});
    const auto begin = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    vertices_of[n] = {begin, static_cast<std::uint32_t>(vertices.size())};
  }
  for (std::size_t n = tree.nodes.size(); n-- > 0;)
    if (const BoxNode& node = tree.nodes[n]; node.count == 0)
      vertices_of[n] = {vertices_of[node.first].begin, vertices_of[node.first + 1].end};
}

void make_vertex_list(std::vector<std::uint32_t>& vertices) {
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  while (vertices.size() % kVertexPadding != 0) vertices.push_back(vertices.back());
}

Box4 box_of(std::span<const std::uint32_t> vertices, const Points& points) {
  Box4 box = detail::empty_box();
  for (std::size_t i = 0; i < vertices.size(); i += kVertexPadding) {
    const Float4 a = points[vertices[i]], b = points[vertices[i + 1]];
    const Float4 c = points[vertices[i + 2]], d = points[vertices[i + 3]];
    box = unite(box, {min(min(a, b), min(c, d)), max(max(a, b), max(c, d))});
  }
  return box;
}

void refit_bottom_up(const TreeShape& shape, const Points& points, std::vector<BoxNode>& nodes) {
  for (std::size_t n = nodes.size(); n-- > 0;) {
    BoxNode& node = nodes[n];
    node.set_box(node.count == 0
                     ? unite(nodes[node.first].box(), nodes[node.first + 1].box())
                     : box_of(shape.vertices_below(static_cast<std::uint32_t>(n)), points));
  }
}

}  // namespace pelt::rivals
