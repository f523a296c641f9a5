#pragma once

/// A scene, made ready for a check.

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/check/settings.hpp"
#include "tools/pelt/scene/self_filters.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <optional>
#include <vector>

namespace pelt::tools::check {

/// Whether frames are queried, or their answers are there already.
enum class Frames { to_query, answered };

/// Everything that the threads of a check share. Immutable once it is prepared. Movable.
struct Stage {
  /// Makes the colliders. Those of answered frames are not fitted to sample poses, which would take
  /// most of the time. Scene and settings must outlive the stage.
  static Result<Stage> make(const scenes::Scene& scene, const CheckSettings& settings,
                            Frames frames = Frames::to_query);

  /// Adds what queries need: the members after `frames`. Error messages name the scene, and the
  /// file or the frame. Cost: with --self-always, that of the check itself.
  Result<void> prepare();

  /// The frame from which the step to `frames[index]` starts; nullopt if there is none.
  /// With --between, a step leads from each frame to the next one of the same take.
  std::optional<std::uint32_t> step_from(std::size_t index) const;

  std::vector<scene::Collider> colliders;
  scene::StagedScene staged;  ///< of the colliders
  const CheckSettings& settings;
  std::vector<std::uint32_t> frames;
  std::optional<scenes::IgnoredPairs> ignored;
  std::optional<scene::SelfFilters> filters;  ///< if bodies are tested against themselves

 private:
  Stage(std::vector<scene::Collider> made, const scenes::Scene& scene,
        const CheckSettings& checked);
};

}  // namespace pelt::tools::check
