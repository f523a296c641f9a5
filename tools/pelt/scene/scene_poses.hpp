#pragma once

/// Poses of a scene's colliders, and a loop that queries them frame by frame.

#include <pelt/crowd.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include "crowd/broad_phase.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <functional>
#include <span>
#include <vector>

namespace pelt::tools::scene {

/// A pose for each collider, in their order.
class ScenePoses {
 public:
  /// `colliders` must outlive the poses.
  explicit ScenePoses(std::span<const Collider> colliders);

  /// Error messages name the instance.
  Result<void> set_palettes(const Palettes& palettes);

  std::span<Pose> poses() { return poses_; }

 private:
  std::span<const Collider> colliders_;
  PartedInstances parted_;
  InputSelection selection_;
  std::vector<Pose> poses_;
};

/// Steps of each frame.
struct FrameSteps {
  std::function<Result<QueryStats>(const Palettes& palettes)> ask;  ///< timed
  std::function<Result<void>(std::uint32_t frame, const Palettes& palettes)> record;
};

struct FrameCosts {
  std::vector<double> seconds;  ///< per frame: `ask`, without sampling
  QueryStats work;
};

/// Samples the palettes of each frame, runs the steps, and shows a progress bar. Stops at the first
/// error, whose message names the frame.
Result<FrameCosts> run_frames(const scenes::Scene& scene, const arguments::FrameRange& frames,
                              const FrameSteps& steps);

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
