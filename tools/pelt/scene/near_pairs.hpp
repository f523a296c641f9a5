#pragma once

#include <pelt/crowd.hpp>
#include <pelt/pose.hpp>

#include "crowd/broad_phase.hpp"

#include <span>
#include <vector>

namespace pelt::tools::scene {

/// Broad phase of queries between two poses: finds the pairs of poses whose boxes are near each
/// other.
class NearPairs {
 public:
  /// Returns pairs a < b in ascending order, valid until the next call. The result contains every
  /// pair whose surfaces are at most `distance` apart, and every pair of which one surface contains
  /// the other. Boxes are computed without posing vertices. Cost: O(n log n) for n poses, plus
  /// the pairs of boxes that overlap along one axis.
  std::span<const CrowdPair> find(std::span<Pose> poses, double distance);

 private:
  detail::Sweep sweep_;
  std::vector<CrowdPair> pairs_;
};

}  // namespace pelt::tools::scene
