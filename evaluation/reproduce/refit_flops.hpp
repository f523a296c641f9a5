#pragma once

#include "evaluation/reproduce/experiment.hpp"

namespace pelt::reproduce {

/// The operations of a refit, counted, beside the formula of section 4.2; a row for each of the
/// three characters.
Result<Table> flops_table();

}  // namespace pelt::reproduce
