#pragma once

#include "evaluation/reproduce/experiment.hpp"

namespace pelt::reproduce {

/// Refitting all spheres of two men, on demand and bottom-up, beside the paper's figures.
Result<Table> all_spheres_table(const Conditions& conditions);

/// Refitting all bounds of the three characters, and building their trees again, by the paper's
/// methods and by ours.
Result<Table> rebuild_table(const Conditions& conditions);

}  // namespace pelt::reproduce
