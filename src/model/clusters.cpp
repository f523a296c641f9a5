#include "model/clusters.hpp"

#include <pelt/mesh.hpp>

#include "base/assert.hpp"
#include "geometry/box4.hpp"
#include "model/tree.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace pelt::detail {
namespace {

Box4 box_of(const Triangle& triangle, const std::vector<Vec3>& positions) {
  Box4 box = empty_box();
  for (const std::uint32_t v : triangle) {
    const Vec3& p = positions[v];
    const Float4 point(p.x, p.y, p.z, 0);
    box = unite(box, {point, point});
  }
  return box;
}

}  // namespace

SampleBoxes::SampleBoxes(std::span<const Triangle> triangles,
                         std::span<const std::vector<Vec3>> samples)
    : triangle_count_(static_cast<std::uint32_t>(triangles.size())),
      sample_count_(static_cast<std::uint32_t>(samples.size())) {
  PELT_ASSERT(!samples.empty());
  boxes_.reserve(triangles.size() * samples.size());
  for (const Triangle& triangle : triangles)
    for (const std::vector<Vec3>& positions : samples)
      boxes_.push_back(box_of(triangle, positions));
}

namespace {

/// Cuts sets of triangles in two at the least cost as defined in clusters.hpp: the sum over both
/// sides of area times number of clusters.
///
/// Large sets are cut between bins, along the axes of every sample pose. Small sets are cut between
/// any two triangles, which fills clusters better. They are sorted by the centres of their boxes in
/// the rest pose only: sorting along the axes of the other samples gains 1 % of area for four times
/// the time.
class ClusterCut {
 public:
  explicit ClusterCut(const SampleBoxes& boxes);

  /// Moves the triangles of the left side to the front of `triangles` and returns their number,
  /// which is at least 1 and less than all. Precondition: more triangles than fit into a cluster.
  std::uint32_t cheapest(std::span<std::uint32_t> triangles);

  /// Returns the number for sides with equal numbers of clusters, whatever the triangles.
  static std::uint32_t halves(std::span<const std::uint32_t> triangles);

 private:
  static constexpr std::uint32_t kBins = 16;

  struct Choice {
    double cost;  // of both sides; areas are summed over the samples
    std::size_t axis;
    std::uint32_t at;  // first bin or first triangle of the right side; 0: no cut yet
  };
  /// The bins along the three axes of a sample pose.
  struct Grid {
    std::uint32_t sample;
    Float4 low, scale;
  };
  struct Key {
    float place;
    std::uint32_t triangle;
  };

  Float4 doubled_centre(std::uint32_t sample, std::uint32_t triangle) const;
  double grow_side(const Box4* boxes);
  void clear_side();

  std::uint32_t cut_between_bins(std::span<std::uint32_t> triangles);
  Grid lay_grid(std::uint32_t sample, std::span<const std::uint32_t> triangles) const;
  std::array<std::uint32_t, 3> bins_of(const Grid& grid, std::uint32_t triangle) const;
  void fill_bins(const Grid& grid, std::span<const std::uint32_t> triangles);
  void weigh_bins(std::size_t axis, Choice& best);
  const Box4* bin(std::size_t axis, std::uint32_t b) const;

  std::uint32_t cut_between_triangles(std::span<std::uint32_t> triangles);
  void sort_keys(std::size_t axis, std::span<const std::uint32_t> triangles);
  void weigh_keys(std::size_t axis, Choice& best);

  const SampleBoxes& boxes_;
  std::vector<Box4> side_;           // [S] boxes of the side that a sweep has collected so far
  std::vector<double> right_costs_;  // by position of the cut

  std::vector<Box4> bins_;  // [3][kBins][S]
  std::array<std::array<std::uint32_t, kBins>, 3> bin_counts_;

  std::vector<Key> keys_;  // of the triangles, sorted along an axis
};

/// Larger sets are cut between bins: sorting them costs more time than it saves area.
constexpr std::uint32_t kMaxSorted = 256;

constexpr double kNever = std::numeric_limits<double>::infinity();

std::uint32_t clusters_for(std::uint32_t triangles) {
  return (triangles + kMaxClusterTriangles - 1) / kMaxClusterTriangles;
}

ClusterCut::ClusterCut(const SampleBoxes& boxes)
    : boxes_(boxes),
      side_(boxes.sample_count()),
      right_costs_(kMaxSorted),
      bins_(std::size_t{3} * kBins * boxes.sample_count()) {}

std::uint32_t ClusterCut::cheapest(std::span<std::uint32_t> triangles) {
  PELT_ASSERT(triangles.size() > kMaxClusterTriangles);
  return triangles.size() > kMaxSorted ? cut_between_bins(triangles)
                                       : cut_between_triangles(triangles);
}

std::uint32_t ClusterCut::halves(std::span<const std::uint32_t> triangles) {
  const auto count = static_cast<std::uint32_t>(triangles.size());
  return clusters_for(count) / 2 * kMaxClusterTriangles;
}

Float4 ClusterCut::doubled_centre(std::uint32_t sample, std::uint32_t triangle) const {
  const Box4& box = boxes_.of(triangle)[sample];
  return box.low + box.high;
}

void ClusterCut::clear_side() { std::fill(side_.begin(), side_.end(), empty_box()); }

/// Adds one box per sample to the side. Returns the area of the side, summed over the samples.
double ClusterCut::grow_side(const Box4* boxes) {
  double area = 0;
  for (Box4& box : side_) {
    box = unite(box, *boxes++);
    area += half_area(box);
  }
  return area;
}

std::uint32_t ClusterCut::cut_between_bins(std::span<std::uint32_t> triangles) {
  Choice best{kNever, 0, 0};
  Grid best_grid{};
  for (std::uint32_t s = 0; s < boxes_.sample_count(); ++s) {
    const Grid grid = lay_grid(s, triangles);
    fill_bins(grid, triangles);
    const double before = best.cost;
    for (std::size_t axis = 0; axis < 3; ++axis) weigh_bins(axis, best);
    if (best.cost < before) best_grid = grid;
  }
  // All centres coincide, or nothing has area.
  if (best.at == 0 || best.cost == 0) return halves(triangles);
  const auto right = std::stable_partition(
      triangles.begin(), triangles.end(),
      [&](std::uint32_t t) { return bins_of(best_grid, t)[best.axis] < best.at; });
  return static_cast<std::uint32_t>(right - triangles.begin());
}

ClusterCut::Grid ClusterCut::lay_grid(std::uint32_t sample,
                                      std::span<const std::uint32_t> triangles) const {
  Box4 box = empty_box();
  for (const std::uint32_t t : triangles) {
    const Float4 centre = doubled_centre(sample, t);
    box = unite(box, {centre, centre});
  }
  const Float4 size = box.high - box.low;
  // An axis without extent has all centres in the first bin.
  const Float4 usable = size - Float4(kBins * std::numeric_limits<float>::min());
  return {sample, box.low, if_positive(usable, Float4(kBins) / size, Float4(0.0f))};
}

std::array<std::uint32_t, 3> ClusterCut::bins_of(const Grid& grid, std::uint32_t triangle) const {
  const Float4 place = (doubled_centre(grid.sample, triangle) - grid.low) * grid.scale;
  const Float4 inside = min(place, Float4(kBins - 1));
  return {static_cast<std::uint32_t>(inside[0]), static_cast<std::uint32_t>(inside[1]),
          static_cast<std::uint32_t>(inside[2])};
}

const Box4* ClusterCut::bin(std::size_t axis, std::uint32_t b) const {
  return bins_.data() + (axis * kBins + b) * boxes_.sample_count();
}

void ClusterCut::fill_bins(const Grid& grid, std::span<const std::uint32_t> triangles) {
  const std::uint32_t samples = boxes_.sample_count();
  std::fill(bins_.begin(), bins_.end(), empty_box());
  for (auto& counts : bin_counts_) counts.fill(0);
  for (const std::uint32_t t : triangles) {
    const auto places = bins_of(grid, t);
    const Box4* boxes = boxes_.of(t);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ++bin_counts_[axis][places[axis]];
      Box4* filled = bins_.data() + (axis * kBins + places[axis]) * samples;
      for (std::uint32_t s = 0; s < samples; ++s) filled[s] = unite(filled[s], boxes[s]);
    }
  }
}

void ClusterCut::weigh_bins(std::size_t axis, Choice& best) {
  const auto& counts = bin_counts_[axis];
  std::uint32_t on_right = 0, on_left = 0;
  clear_side();
  for (std::uint32_t b = kBins - 1; b > 0; --b) {
    on_right += counts[b];
    right_costs_[b] = on_right == 0 ? kNever : grow_side(bin(axis, b)) * clusters_for(on_right);
  }
  clear_side();
  for (std::uint32_t b = 1; b < kBins; ++b) {
    on_left += counts[b - 1];
    if (on_left == 0) continue;
    const double cost = grow_side(bin(axis, b - 1)) * clusters_for(on_left) + right_costs_[b];
    if (cost < best.cost) best = {cost, axis, b};
  }
}

std::uint32_t ClusterCut::cut_between_triangles(std::span<std::uint32_t> triangles) {
  Choice best{kNever, 0, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sort_keys(axis, triangles);
    weigh_keys(axis, best);
  }
  sort_keys(best.axis, triangles);
  for (std::size_t i = 0; i < keys_.size(); ++i) triangles[i] = keys_[i].triangle;
  return best.cost > 0 ? best.at : halves(triangles);
}

void ClusterCut::sort_keys(std::size_t axis, std::span<const std::uint32_t> triangles) {
  keys_.clear();
  for (const std::uint32_t t : triangles)
    keys_.push_back({doubled_centre(0, t)[static_cast<int>(axis)], t});
  std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) {
    return a.place != b.place ? a.place < b.place : a.triangle < b.triangle;
  });
}

void ClusterCut::weigh_keys(std::size_t axis, Choice& best) {
  const auto count = static_cast<std::uint32_t>(keys_.size());
  clear_side();
  for (std::uint32_t k = count - 1; k > 0; --k)
    right_costs_[k] = grow_side(boxes_.of(keys_[k].triangle)) * clusters_for(count - k);
  clear_side();
  for (std::uint32_t k = 1; k < count; ++k) {
    const Box4* boxes = boxes_.of(keys_[k - 1].triangle);
    const double cost = grow_side(boxes) * clusters_for(k) + right_costs_[k];
    if (cost < best.cost) best = {cost, axis, k};
  }
}

/// From this depth on, sets are halved, which takes at most 31 levels.
constexpr std::uint32_t kHalvingDepth = kMaxClusterTreeDepth - 32;

class ClusterTreeBuilder {
 public:
  explicit ClusterTreeBuilder(const SampleBoxes& boxes) : boxes_(boxes), cut_(boxes) {
    tree_.triangle_order.resize(boxes.triangle_count());
    std::iota(tree_.triangle_order.begin(), tree_.triangle_order.end(), 0);
  }

  ClusterTree build() && {
    add_node(0, boxes_.triangle_count(), 1);
    for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
      if (tree_.nodes[n].count > kMaxClusterTriangles) split(n);
    return std::move(tree_);
  }

 private:
  void add_node(std::uint32_t first, std::uint32_t count, std::uint32_t depth) {
    tree_.nodes.push_back({first, count, 0, mean_area(triangles(first, count))});
    depths_.push_back(depth);
  }

  void split(std::uint32_t n) {
    const std::uint32_t first = tree_.nodes[n].first, count = tree_.nodes[n].count;
    const auto set = triangles(first, count);
    const std::uint32_t left =
        depths_[n] < kHalvingDepth ? cut_.cheapest(set) : ClusterCut::halves(set);
    tree_.nodes[n].left_child = static_cast<std::uint32_t>(tree_.nodes.size());
    add_node(first, left, depths_[n] + 1);
    add_node(first + left, count - left, depths_[n] + 1);
  }

  std::span<std::uint32_t> triangles(std::uint32_t first, std::uint32_t count) {
    return {tree_.triangle_order.data() + first, count};
  }

  double mean_area(std::span<const std::uint32_t> set) const {
    double sum = 0;
    for (std::uint32_t s = 0; s < boxes_.sample_count(); ++s) {
      Box4 box = empty_box();
      for (const std::uint32_t t : set) box = unite(box, boxes_.of(t)[s]);
      sum += half_area(box);
    }
    return sum / boxes_.sample_count();
  }

  const SampleBoxes& boxes_;
  ClusterCut cut_;
  ClusterTree tree_;
  std::vector<std::uint32_t> depths_;  // by node
};

}  // namespace

ClusterTree build_cluster_tree(const SampleBoxes& boxes) {
  PELT_ASSERT(boxes.triangle_count() > 0);
  return ClusterTreeBuilder(boxes).build();
}

}  // namespace pelt::detail
