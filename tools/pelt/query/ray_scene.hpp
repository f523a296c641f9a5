#pragma once

/// `pelt ray` after its arguments: frames run through, lines written, a summary printed.

#include <pelt/ray.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/frame_range.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::query {

struct RaySettings {
  std::vector<Ray> rays;
  Facing facing = Facing::both;
  arguments::FrameRange frames;
};

/// `jsonl` as for LineOutput; the summary goes to `words`.
Result<void> ray_scene(const scenes::Scene& scene, const RaySettings& settings,
                       const arguments::ModelArguments& models, const std::string& jsonl,
                       std::ostream& words);

}  // namespace pelt::tools::query
