#include "tools/pelt/bench/bench_frames.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/output/text.hpp"

namespace pelt::tools::bench {

Result<std::vector<std::uint32_t>> choose_frames(
    const scenes::Scene& scene, const std::optional<arguments::FrameRange>& chosen) {
  const arguments::FrameRange frames = chosen.value_or(arguments::FrameRange{0, scene.frame_count});
  if (frames.end <= scene.frame_count) return frames.frames();
  return output::bad_argument("--frames",
                              std::to_string(frames.end) + " goes beyond the last frame",
                              scene.name + " has frames 0:" + std::to_string(scene.frame_count));
}

Result<void> require_two_instances(const scenes::Scene& scene, const std::string& alternative) {
  if (scene.instances.size() >= 2) return {};
  return output::bad_argument(asset::printable(scene.name),
                              "has " + output::counted(scene.instances.size(), "instance") +
                                  ", so there is no pair to measure",
                              "add instances until there are at least two" + alternative);
}

}  // namespace pelt::tools::bench
