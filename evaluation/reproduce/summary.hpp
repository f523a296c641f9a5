#pragma once

#include "evaluation/reproduce/report.hpp"

#include <span>

namespace pelt::reproduce {

/// What the report begins with: what each method is, and what became of the paper's claims, taken
/// from the tables of `sections`; claims whose section is not among them are left out.
Section summary(std::span<const Section> sections);

}  // namespace pelt::reproduce
