#pragma once

/// The chart of `pelt-lab bench --anytime`.

#include "evaluation/bench/anytime_figures.hpp"

#include <string>
#include <vector>

namespace pelt::lab {

/// The chart as SVG: what is known over the time, a row of panels for each scene. The methods of
/// all scenes must be the same. Precondition: not empty.
std::string anytime_chart(const std::vector<AnytimeSceneFigures>& scenes);

}  // namespace pelt::lab
