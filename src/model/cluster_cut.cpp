#include "model/cluster_cut.hpp"

#include "base/assert.hpp"
#include "model/tree.hpp"

#include <algorithm>
#include <limits>

namespace pelt::detail {
namespace {

/// Larger sets are cut between bins: sorting them costs more time than it saves area.
constexpr std::uint32_t kMaxSorted = 256;

constexpr double kNever = std::numeric_limits<double>::infinity();

std::uint32_t clusters_for(std::uint32_t triangles) {
  return (triangles + kMaxClusterTriangles - 1) / kMaxClusterTriangles;
}

}  // namespace

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

}  // namespace pelt::detail
