#include "tools/pelt/scene/near_pairs.hpp"

#include <pelt/bounds.hpp>

#include <algorithm>
#include <cmath>

namespace pelt::tools::scene {
namespace {

/// Returns the box of the pose, grown by at least `margin` on each side.
detail::RootBox wide_box(Pose& pose, double margin) {
  Bounds around;
  bounds(pose, around);
  const Box& box = around.box;
  const float low[] = {box.low.x, box.low.y, box.low.z};
  const float high[] = {box.high.x, box.high.y, box.high.z};
  detail::RootBox wide = {};
  for (int axis = 0; axis < 3; ++axis) {
    // One step outwards compensates for the rounding of the sum.
    const auto widened = [&](float side, double by) {
      return static_cast<float>(double{side} + by);
    };
    wide.low[axis] = std::nextafter(widened(low[axis], -margin), -HUGE_VALF);
    wide.high[axis] = std::nextafter(widened(high[axis], margin), HUGE_VALF);
  }
  return wide;
}

}  // namespace

std::span<const CrowdPair> NearPairs::find(std::span<Pose> poses, double distance) {
  sweep_.clear();
  pairs_.clear();
  for (std::uint32_t i = 0; i < poses.size(); ++i) sweep_.add(i, wide_box(poses[i], distance / 2));
  if (!poses.empty()) sweep_.find_pairs(pairs_);
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace pelt::tools::scene
