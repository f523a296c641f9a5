#include "tools/pelt/check/stage.hpp"

#include "scenes/takes.hpp"
#include "text/message.hpp"

#include <utility>

namespace pelt::tools::check {

/// The span of `staged` stays valid when the colliders are moved.
Stage::Stage(std::vector<scene::Collider> made, const scenes::Scene& scene,
             const CheckSettings& checked)
    : colliders(std::move(made)),
      staged(scene, colliders),
      settings(checked),
      frames(checked.frames.frames()) {}

Result<Stage> Stage::make(const scenes::Scene& scene, const CheckSettings& settings,
                          Frames frames) {
  arguments::ModelArguments models = settings.options.scene.models;
  if (frames == Frames::answered) models.samples = 0;
  auto colliders = scene::make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  return Stage(std::move(*colliders), scene, settings);
}

Result<void> Stage::prepare() {
  const auto in_scene = [this](const Error& error) {
    return text::prefixed(staged.scene.name, error);
  };
  auto pairs = scenes::IgnoredPairs::make(scenes::characters_of(staged.scene), settings.ignore);
  if (!pairs) return in_scene(pairs.error());
  ignored = std::move(*pairs);
  if (!settings.self.asks_self()) return {};
  auto made = scene::make_self_filters(staged, settings.self.rules, settings.frames);
  if (!made) return in_scene(made.error());
  filters = std::move(*made);
  return {};
}

std::optional<std::uint32_t> Stage::step_from(std::size_t index) const {
  if (!settings.substeps || index == 0) return std::nullopt;
  const auto take_of = [&](std::uint32_t f) { return scenes::take_index(staged.scene, f); };
  const std::uint32_t from = frames[index - 1];
  return take_of(from) == take_of(frames[index]) ? std::optional(from) : std::nullopt;
}

}  // namespace pelt::tools::check
