#include "tools/pelt/bench/runner.hpp"

#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/methods/self_methods.hpp"

#include <algorithm>
#include <array>

namespace pelt::tools::bench {

const char* name_of(Question question) { return question == Question::all ? "all" : "first"; }

const char* name_of(Asked asked) {
  constexpr std::array kNames = {"pairs", "crowd", "self", "none"};
  return kNames[static_cast<std::size_t>(asked)];
}

const char* name_of(Time time) { return time == Time::thread ? "thread" : "wall"; }

BenchMethod method_of(methods::MethodKind method) {
  return {std::string(method.name), [method](std::span<const scene::Collider> colliders) {
            return scene::SceneQuery(colliders, method.make());
          }};
}

BenchMethod self_method(methods::MethodKind method) {
  const auto make = [method](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::of_each(colliders, method.make());
  };
  return {std::string(method.name), make, method == methods::kBoxes ? Asked::none : Asked::self};
}

BenchMethod crowd_method(std::uint32_t threads) {
  const auto make = [threads](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::as_crowd(colliders, threads);
  };
  return {std::string(methods::kOnDemand.name), make, Asked::crowd, threads};
}

Time time_of(std::span<const BenchMethod> methods) {
  const bool as_crowd = std::any_of(methods.begin(), methods.end(), [](const BenchMethod& method) {
    return method.asked == Asked::crowd;
  });
  return as_crowd ? Time::wall : Time::thread;
}

Result<std::vector<std::uint32_t>> choose_frames(
    const scenes::Scene& scene, const std::optional<arguments::FrameRange>& chosen) {
  const arguments::FrameRange frames = chosen.value_or(arguments::FrameRange{0, scene.frame_count});
  if (frames.end <= scene.frame_count) return frames.frames();
  return text::bad_argument("--frames", std::to_string(frames.end) + " goes beyond the last frame",
                            scene.name + " has frames 0:" + std::to_string(scene.frame_count));
}

Result<void> require_two_instances(const scenes::Scene& scene, const std::string& alternative) {
  if (scene.instances.size() >= 2) return {};
  return text::bad_argument(text::printable(scene.name),
                            "has " + text::counted(scene.instances.size(), "instance") +
                                ", so there is no pair to measure",
                            "add instances until there are at least two" + alternative);
}

void Runner::ask(Question question) {
  Limits limits;
  if (question == Question::first) limits.max_contacts = 1;
  query_.collide(limits, found_);
}

Error in_frame(std::uint32_t frame, const Error& error) {
  return text::prefixed("frame " + std::to_string(frame), error);
}

}  // namespace pelt::tools::bench
