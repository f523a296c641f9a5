#pragma once

/// Runs `pelt bench` on scenes: builds models, compares the answers of all engines, and measures
/// them.

#include "tools/pelt/arguments/exit_code.hpp"
#include "tools/pelt/arguments/frame_range.hpp"
#include "tools/pelt/bench/bench_report.hpp"

#include <optional>

namespace pelt::tools {

struct BenchSettings {
  std::vector<Engine> engines;
  std::vector<Question> questions;
  std::vector<Cache> caches;
  std::uint32_t repetitions = kEnoughRepetitions;
  std::optional<arguments::FrameRange> frames;  ///< nothing: all of the scene
  arguments::ModelArguments models;
};

/// Appends the scene's figures, unless an engine does not answer as the paper's does: then it is
/// named on `errors`, no time is taken, and ExitCode::internal returned.
Result<arguments::ExitCode> bench_scene(const scenes::Scene& scene, const BenchSettings& settings,
                                        std::vector<SceneFigures>& figures, std::ostream& errors);

}  // namespace pelt::tools
