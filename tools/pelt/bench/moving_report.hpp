#pragma once

/// The output of `pelt bench --moving`, as text and as JSON.

#include "tools/pelt/bench/moving_measure.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::bench {

/// Figures of one question to one method.
struct MovingFigures {
  std::string method;
  MovingQuestion question = MovingQuestion::pairs;
  MovingAnswer answer;
  MovingTimes times;
};

struct MovingSceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t vertices = 0;   ///< of all instances
  std::uint64_t steps = 0;
  std::uint32_t repetitions = 0;
  double skinning_us = 0;              ///< to skin all vertices once, on average
  std::vector<MovingFigures> figures;  ///< not empty; grouped by question
};

void print_moving_figures(const MovingSceneFigures& scene, std::ostream& out);

/// Returns the figures as JSON.
std::string moving_figures_json(const std::vector<MovingSceneFigures>& scenes);

}  // namespace pelt::tools::bench
