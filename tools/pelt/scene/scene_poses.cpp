#include "tools/pelt/scene/scene_poses.hpp"

#include "text/message.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <chrono>

namespace pelt::tools::scene {

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

}  // namespace pelt::tools::scene
