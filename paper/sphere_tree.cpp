#include "paper/sphere_tree.hpp"

#include "paper/min_sphere.hpp"

#include <algorithm>

namespace pelt::paper {
namespace {

/// Three times a triangle's centroid along each axis, which suffices to compare triangles.
std::array<double, 3> centroid(std::span<const Vec3> positions, const Triangle& triangle) {
  std::array<double, 3> sum = {0, 0, 0};
  for (const std::uint32_t v : triangle) {
    sum[0] += static_cast<double>(positions[v].x);
    sum[1] += static_cast<double>(positions[v].y);
    sum[2] += static_cast<double>(positions[v].z);
  }
  return sum;
}

class BinaryBuilder {
 public:
  BinaryBuilder(std::span<const Vec3> positions, std::span<const Triangle> triangles)
      : positions_(positions), triangles_(triangles), seen_in_(positions.size(), 0) {
    const auto count = static_cast<std::uint32_t>(triangles.size());
    tree_.triangle_order.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) tree_.triangle_order[t] = t;
    for (const Triangle& triangle : triangles) centroids_.push_back(centroid(positions, triangle));
    tree_.nodes.reserve(2 * std::size_t{count} - 1);
  }

  SphereTree build() && {
    add_node(0, static_cast<std::uint32_t>(triangles_.size()));
    for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
      if (tree_.nodes[n].triangle_count > 1) split_node(n);
    return std::move(tree_);
  }

 private:
  void add_node(std::uint32_t first, std::uint32_t count) {
    Node node;
    node.first_triangle = first;
    node.triangle_count = count;
    node.rest = enclose(first, count);
    tree_.nodes.push_back(node);
  }

  void split_node(std::uint32_t n) {
    const std::uint32_t first = tree_.nodes[n].first_triangle;
    const std::uint32_t count = tree_.nodes[n].triangle_count;
    const std::uint32_t left = partition(first, count);
    tree_.nodes[n].first_child = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes[n].child_count = 2;
    add_node(first, left);
    add_node(first + left, count - left);
  }

  /// The minimal sphere around the vertices of a range of triangles.
  Sphere enclose(std::uint32_t first, std::uint32_t count) {
    points_.clear();
    ++stamp_;
    for (std::uint32_t i = first; i < first + count; ++i)
      for (const std::uint32_t v : triangles_[tree_.triangle_order[i]]) {
        if (seen_in_[v] == stamp_) continue;
        seen_in_[v] = stamp_;
        points_.push_back(positions_[v]);
      }
    return min_sphere(points_);
  }

  /// Quinlan 1994: cuts the box around the centroids across its longest axis, at their mean.
  /// Returns the number of triangles on the left. If the mean does not separate them (all centroids
  /// coincide), returns half of the triangles.
  std::uint32_t partition(std::uint32_t first, std::uint32_t count) {
    const auto begin = tree_.triangle_order.begin() + first;
    const auto end = begin + count;
    const Cut cut = quinlan_cut({begin, end});
    const auto middle = std::stable_partition(
        begin, end, [&](std::uint32_t t) { return centroids_[t][cut.axis] < cut.position; });
    const auto left = static_cast<std::uint32_t>(middle - begin);
    return left == 0 || left == count ? count / 2 : left;
  }

  struct Cut {
    int axis;
    double position;
  };

  Cut quinlan_cut(std::span<const std::uint32_t> triangles) const {
    std::array<double, 3> low = centroids_[triangles[0]], high = low, sum = {0, 0, 0};
    for (const std::uint32_t t : triangles)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], centroids_[t][axis]);
        high[axis] = std::max(high[axis], centroids_[t][axis]);
        sum[axis] += centroids_[t][axis];
      }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
    return {static_cast<int>(longest), sum[longest] / static_cast<double>(triangles.size())};
  }

  std::span<const Vec3> positions_;
  std::span<const Triangle> triangles_;
  std::vector<std::array<double, 3>> centroids_;
  std::vector<std::uint32_t> seen_in_;  // by vertex: the last node that contained it
  std::uint32_t stamp_ = 0;
  std::vector<Vec3> points_;
  SphereTree tree_;
};

/// Appends to `children` the binary children of `node` under a surviving parent of radius
/// `parent_radius`. A deleted child is replaced by its own children.
void surviving_children(const SphereTree& binary, const Node& node, float parent_radius,
                        float ratio, std::vector<std::uint32_t>& children) {
  for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
    const Node& child = binary.nodes[c];
    if (!child.is_leaf() && child.rest.radius > ratio * parent_radius)
      surviving_children(binary, child, parent_radius, ratio, children);
    else
      children.push_back(c);
  }
}

}  // namespace

SphereTree build_binary_tree(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  return BinaryBuilder(positions, triangles).build();
}

SphereTree collapse(const SphereTree& binary, float ratio) {
  SphereTree tree;
  tree.triangle_order = binary.triangle_order;
  tree.nodes.push_back(binary.nodes[0]);
  std::vector<std::uint32_t> origin = {0};  // by surviving node: its number in the binary tree
  std::vector<std::uint32_t> children;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    children.clear();
    const Node& node = binary.nodes[origin[n]];
    if (node.is_leaf()) continue;
    surviving_children(binary, node, node.rest.radius, ratio, children);
    tree.nodes[n].first_child = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes[n].child_count = static_cast<std::uint32_t>(children.size());
    for (const std::uint32_t child : children) {
      tree.nodes.push_back(binary.nodes[child]);
      origin.push_back(child);
    }
  }
  return tree;
}

SphereTree build_sphere_tree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                             float ratio) {
  return collapse(build_binary_tree(positions, triangles), ratio);
}

std::vector<LevelStatistics> level_statistics(const SphereTree& tree,
                                              std::span<const float> radii) {
  std::vector<LevelStatistics> levels;
  std::vector<std::uint32_t> level_of(tree.nodes.size(), 0);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c)
      level_of[c] = level_of[n] + 1;
    if (level_of[n] == levels.size()) levels.emplace_back();
    LevelStatistics& level = levels[level_of[n]];
    ++level.nodes;
    level.leaves += node.is_leaf();
    level.mean_radius += static_cast<double>(radii[n]);
    level.max_children = std::max(level.max_children, node.child_count);
  }
  for (LevelStatistics& level : levels) level.mean_radius /= level.nodes;
  return levels;
}

std::vector<LevelStatistics> level_statistics(const SphereTree& tree) {
  std::vector<float> radii;
  for (const Node& node : tree.nodes) radii.push_back(node.rest.radius);
  return level_statistics(tree, radii);
}

}  // namespace pelt::paper
