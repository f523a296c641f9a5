#pragma once

/// Runs `pelt bench --anytime` on scenes: builds models, compares the contacts of all complete
/// searches with those of `collide`, and measures what is known before the end.

#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/anytime_figures.hpp"

#include <optional>
#include <ostream>
#include <string>

namespace pelt::tools::bench {

struct AnytimeSettings {
  std::string program = "pelt";             ///< for messages
  std::vector<AnytimeBenchMethod> methods;  ///< one of them has the name `contacts`
  std::uint32_t repetitions = 9;
  std::optional<arguments::FrameRange> frames;  ///< nullopt: all frames of the scene
  arguments::ModelArguments models;
};

/// Appends the scene's figures. If a complete search differs from `collide`, prints its name to
/// `errors`, measures nothing, and returns ExitCode::internal.
Result<arguments::ExitCode> bench_anytime(const scenes::Scene& scene,
                                          const AnytimeSettings& settings,
                                          std::vector<AnytimeSceneFigures>& figures,
                                          std::ostream& errors);

}  // namespace pelt::tools::bench
