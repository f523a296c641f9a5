#pragma once

#include "evaluation/reproduce/experiment.hpp"

namespace pelt::reproduce {

/// All spheres of two men, refitted on demand and bottom-up, beside what the paper prints.
Result<Table> all_spheres_table(const Conditions& conditions);

/// All bounds of the three characters refitted, and their trees built anew: by the paper's methods
/// and by ours.
Result<Table> rebuild_table(const Conditions& conditions);

}  // namespace pelt::reproduce
