#pragma once

#include <pelt/crowd.hpp>
#include <pelt/pose.hpp>

#include "crowd/sweep.hpp"

#include <span>
#include <vector>

namespace pelt::tools::scene {

/// The broad phase of queries that ask two poses at a time: finds the pairs of poses whose boxes
/// are near each other.
class NearPairs {
 public:
  /// Pairs a < b in ascending order. Contains every pair whose surfaces are at most `distance`
  /// apart, and every pair of which one surface lies within the other. Boxes come from the joint
  /// palettes alone: O(n log n) for n poses, plus the pairs of boxes that overlap along one axis.
  /// The result is valid until the next call.
  std::span<const CrowdPair> find(std::span<Pose> poses, double distance);

 private:
  detail::Sweep sweep_;
  std::vector<CrowdPair> pairs_;
};

}  // namespace pelt::tools::scene
