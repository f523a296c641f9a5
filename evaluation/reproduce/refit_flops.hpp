#pragma once

#include "evaluation/reproduce/experiment.hpp"

namespace pelt::reproduce {

/// The counted operations of a refit beside the formula of section 4.2, one row for each of the
/// three characters.
Result<Table> flops_table();

}  // namespace pelt::reproduce
