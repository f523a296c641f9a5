#pragma once

/// Runs `pelt-lab bench --anytime` on scenes: builds models, compares the contacts of all complete
/// searches with those of `collide`, and measures what is known before the end.

#include "evaluation/bench/anytime_measure.hpp"
#include "tools/pelt/bench/bench_scene.hpp"

#include <optional>

namespace pelt::lab {

struct AnytimeSettings {
  std::string program = "pelt-lab";         ///< for messages
  std::vector<AnytimeBenchMethod> methods;  ///< one of them has the name `contacts`
  std::uint32_t repetitions = tools::bench::kEnoughRepetitions;
  std::optional<tools::arguments::FrameRange> frames;  ///< nullopt: all frames of the scene
  tools::arguments::ModelArguments models;
};

/// Returns the scene's figures. If a complete search differs from `collide`, prints its name to
/// `errors`, measures nothing, and returns nullopt.
Result<std::optional<AnytimeSceneFigures>> bench_anytime(const scenes::Scene& scene,
                                                         const AnytimeSettings& settings,
                                                         std::ostream& errors);

/// An area of a method over that of the method `paper`; nullopt if `paper` was not measured, or
/// lists nothing in time.
std::optional<double> of_paper(const AnytimeSceneFigures& scene,
                               const AnytimeMethodFigures& figures,
                               double AnytimeMethodFigures::*area);

void print_figures(const AnytimeSceneFigures& scene, std::ostream& out);

/// A scene of --json.
tools::bench::Row scene_json(const AnytimeSceneFigures& scene);

}  // namespace pelt::lab
