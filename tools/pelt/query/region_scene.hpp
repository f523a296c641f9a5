#pragma once

/// `pelt region` after its arguments: frames run through, lines written, a summary printed.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/frame_range.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/arguments/region_arguments.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <ostream>
#include <string>

namespace pelt::tools::query {

struct RegionSettings {
  arguments::ChosenRegion region;
  scene::Granularity granularity = scene::Granularity::instance;
  bool finds_triangles = false;
  arguments::FrameRange frames;
};

/// `jsonl` as for LineOutput; the summary goes to `words`.
Result<void> region_scene(const scenes::Scene& scene, const RegionSettings& settings,
                          const arguments::ModelArguments& models, const std::string& jsonl,
                          std::ostream& words);

}  // namespace pelt::tools::query
