#pragma once

/// `pelt distance` after its arguments: frames run through, lines written, a summary printed.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/frame_range.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <limits>
#include <ostream>
#include <string>

namespace pelt::tools::query {

struct DistanceSettings {
  scene::Granularity granularity = scene::Granularity::instance;
  double within = std::numeric_limits<double>::infinity();  ///< nothing further is looked for
  arguments::FrameRange frames;
};

/// `jsonl` as for LineOutput; the summary goes to `words`.
Result<void> distance_scene(const scenes::Scene& scene, const DistanceSettings& settings,
                            const arguments::ModelArguments& models, const std::string& jsonl,
                            std::ostream& words);

}  // namespace pelt::tools::query
