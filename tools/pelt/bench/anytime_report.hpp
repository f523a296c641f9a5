#pragma once

/// The output of `pelt bench --anytime`, as text and as JSON.

#include "tools/pelt/bench/anytime_figures.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::bench {

/// An area of a method over that of the method `paper`; nullopt if `paper` was not measured, or
/// lists nothing in time.
std::optional<double> of_paper(const AnytimeSceneFigures& scene,
                               const AnytimeMethodFigures& figures,
                               double AnytimeMethodFigures::*area);

void print_anytime_figures(const AnytimeSceneFigures& scene, std::ostream& out);

/// Returns the figures as JSON.
std::string anytime_figures_json(const std::vector<AnytimeSceneFigures>& scenes);

}  // namespace pelt::tools::bench
