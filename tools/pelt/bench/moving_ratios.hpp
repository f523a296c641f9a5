#pragma once

/// Ratios of `pelt bench --moving`, which can be compared between machines.

#include "tools/pelt/bench/moving_report.hpp"

#include <optional>
#include <string_view>

namespace pelt::tools::bench {

/// The figures of a question to a method, or null.
const MovingFigures* find_figures(const MovingSceneFigures& scene, std::string_view method,
                                  MovingQuestion question);

/// The cost over that of the discrete query of on_demand; nullopt if that was not measured.
std::optional<double> of_collide(const MovingSceneFigures& scene, const MovingFigures& figures);

/// The cost over that of on_demand for the same question.
std::optional<double> of_on_demand(const MovingSceneFigures& scene, const MovingFigures& figures);

}  // namespace pelt::tools::bench
