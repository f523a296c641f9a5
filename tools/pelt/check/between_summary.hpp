#pragma once

/// The lines of the summary for `pelt check --between`.

#include "tools/pelt/check/between_check.hpp"
#include "tools/pelt/check/summary_lists.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <ostream>

namespace pelt::tools::check {

/// Prints the contacts between frames, the worst steps, and the deviation from straight lines.
void print_between(const scene::StagedScene& staged, const BetweenReport& report,
                   const ListLength& length, std::ostream& out);

/// Prints the parts and the joints that touch between frames. Precondition: some do.
void print_touching_between(const scenes::Scene& scene, const BetweenReport& report,
                            const ListLength& length, std::ostream& out);

void print_costs_between(const BetweenReport& report, std::ostream& out);

}  // namespace pelt::tools::check
