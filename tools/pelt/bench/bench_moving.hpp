#pragma once

/// Runs `pelt bench --moving` on scenes: builds models, compares the answers of all methods with
/// those of brute force, and measures them.

#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/moving_report.hpp"

#include <optional>
#include <ostream>
#include <string>

namespace pelt::tools::bench {

struct MovingSettings {
  std::string program = "pelt";  ///< for messages
  std::vector<MovingBenchMethod> methods;
  std::vector<MovingQuestion> questions{kMovingQuestions.begin(), kMovingQuestions.end()};
  std::uint32_t repetitions = 9;

  /// Frames with which steps begin; nullopt: all frames of the scene. The last frame of a scene, or
  /// of a take, begins no step.
  std::optional<arguments::FrameRange> frames;
  arguments::ModelArguments models;
};

/// The steps that begin with these frames, or an error if there are none.
Result<std::vector<Step>> choose_steps(const scenes::Scene& scene,
                                       const std::optional<arguments::FrameRange>& chosen);

MovingBenchMethod moving_method_of(const methods::MovingMethodKind& kind);

/// Appends the scene's figures. If the answers of a method differ from those of brute force, prints
/// its name to `errors`, measures nothing, and returns ExitCode::internal.
Result<arguments::ExitCode> bench_moving(const scenes::Scene& scene, const MovingSettings& settings,
                                         std::vector<MovingSceneFigures>& figures,
                                         std::ostream& errors);

}  // namespace pelt::tools::bench
