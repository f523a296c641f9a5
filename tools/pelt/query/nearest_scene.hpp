#pragma once

/// `pelt distance --from` after its arguments: what is nearest to points, frame by frame.

#include "tools/pelt/query/distance_scene.hpp"

#include <vector>

namespace pelt::tools::query {

/// `jsonl` as for LineOutput; the summary goes to `words`.
Result<void> nearest_scene(const scenes::Scene& scene, std::span<const Vec3> points,
                           const DistanceSettings& settings,
                           const arguments::ModelArguments& models, const std::string& jsonl,
                           std::ostream& words);

}  // namespace pelt::tools::query
