#pragma once

/// `pelt bounds` after its arguments: frames run through, lines written, a summary printed.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/frame_range.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <ostream>
#include <string>

namespace pelt::tools::query {

enum class BoundsBy { instance, part, joint };

enum class BoundsKind {
  guaranteed,  ///< from the joint palette alone
  exact,       ///< the smallest box
};

struct BoundsSettings {
  BoundsBy by = BoundsBy::instance;
  BoundsKind kind = BoundsKind::guaranteed;
  arguments::FrameRange frames;
};

/// `jsonl` as for LineOutput; the summary goes to `words`.
Result<void> bounds_scene(const scenes::Scene& scene, const BoundsSettings& settings,
                          const arguments::ModelArguments& models, const std::string& jsonl,
                          std::ostream& words);

}  // namespace pelt::tools::query
