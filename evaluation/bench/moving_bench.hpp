#pragma once

/// Runs `pelt-lab bench --moving` on scenes: builds models, compares the answers of all methods
/// with those of brute force, and measures them.

#include "evaluation/bench/moving_measure.hpp"
#include "tools/pelt/bench/bench_scene.hpp"

namespace pelt::lab {

struct MovingSettings {
  std::string program = "pelt-lab";  ///< for messages
  std::vector<MovingBenchMethod> methods;
  std::vector<MovingQuestion> questions{kMovingQuestions.begin(), kMovingQuestions.end()};
  std::uint32_t repetitions = tools::bench::kEnoughRepetitions;
  std::optional<tools::arguments::FrameRange> frames;  ///< see `choose_steps`
  tools::arguments::ModelArguments models;
};

/// Figures of one question to one method.
struct MovingFigures {
  std::string method;
  MovingQuestion question = MovingQuestion::pairs;
  MovingAnswer answer;
  Times times;  ///< per step
};

struct MovingSceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t steps = 0;
  std::uint32_t repetitions = 0;
  tools::bench::Skinning skinning;     ///< at the ends of the steps
  std::vector<MovingFigures> figures;  ///< not empty; grouped by question
};

/// The ratios of the tables and of --against.
inline constexpr tools::bench::Yardstick kMovingYardsticks[] = {
    {"of_collide", "of collide", "on_demand", true, true, "collide"},
    {"of_on_demand", "of on_demand", "on_demand", true, true}};

/// Returns the scene's figures. If the answers of a method differ from those of brute force, prints
/// its name to `errors`, measures nothing, and returns nullopt.
Result<std::optional<MovingSceneFigures>> bench_moving(const scenes::Scene& scene,
                                                       const MovingSettings& settings,
                                                       std::ostream& errors);

void print_figures(const MovingSceneFigures& scene, std::ostream& out);

/// A scene of --json.
tools::bench::Row scene_json(const MovingSceneFigures& scene);

}  // namespace pelt::lab
