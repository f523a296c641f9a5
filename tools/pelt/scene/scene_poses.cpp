#include "tools/pelt/scene/scene_poses.hpp"

#include <pelt/bounds.hpp>

#include "text/message.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <algorithm>
#include <chrono>
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

ScenePoses::ScenePoses(std::span<const Collider> colliders)
    : colliders_(colliders), parted_(colliders) {
  for (const Collider& collider : colliders) poses_.emplace_back(collider.model);
}

Result<void> ScenePoses::set_palettes(const Palettes& palettes) {
  if (Result<void> checked = parted_.check(palettes); !checked) return checked;
  for (std::size_t c = 0; c < colliders_.size(); ++c) {
    const auto posed = set_pose(selection_.select(palettes, colliders_[c]), poses_[c]);
    if (!posed) return in_instance(colliders_[c].instance, posed.error());
  }
  return {};
}

Result<FrameCosts> run_frames(const scenes::Scene& scene, const arguments::FrameRange& frames,
                              const FrameSteps& steps) {
  using Clock = std::chrono::steady_clock;
  FrameCosts costs;
  asset::SampleScratch scratch;
  Palettes palettes;
  const std::vector<std::uint32_t> numbers = frames.frames();
  output::Progress progress(numbers.size());
  for (const std::uint32_t frame : numbers) {
    const auto in_frame = [&](const Error& error) {
      return text::prefixed(frame_words(scene, frame), error);
    };
    sample_palettes(scene, frame, scratch, palettes);
    const Clock::time_point begin = Clock::now();
    const Result<QueryStats> work = steps.ask(palettes);
    if (!work) return in_frame(work.error());
    costs.seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    costs.work += *work;
    if (const auto recorded = steps.record(frame, palettes); !recorded)
      return in_frame(recorded.error());
    progress.advance();
  }
  return costs;
}

std::span<const CrowdPair> NearPairs::find(std::span<Pose> poses, double distance) {
  sweep_.clear();
  pairs_.clear();
  for (std::uint32_t i = 0; i < poses.size(); ++i) sweep_.add(i, wide_box(poses[i], distance / 2));
  if (!poses.empty()) sweep_.find_pairs(pairs_);
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace pelt::tools::scene
