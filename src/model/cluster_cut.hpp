#pragma once

#include "model/sample_boxes.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

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

}  // namespace pelt::detail
