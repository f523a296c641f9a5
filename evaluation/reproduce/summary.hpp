#pragma once

#include "evaluation/reproduce/report.hpp"

#include <span>

namespace pelt::reproduce {

/// The first section of the report: describes each method, and compares the paper's claims with the
/// tables of `sections`. Leaves out claims whose section is missing.
Section summary(std::span<const Section> sections);

}  // namespace pelt::reproduce
