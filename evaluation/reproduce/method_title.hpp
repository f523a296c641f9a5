#pragma once

#include "evaluation/methods/method.hpp"

#include <string>

namespace pelt::reproduce {

/// What the report calls a method, in text, tables and legends alike; keys of columns keep the
/// name that the command line has for it.
std::string title_of(bench::MethodKind method);

/// What it does and where it is from, for those who have not read the code.
std::string description_of(bench::MethodKind method);

}  // namespace pelt::reproduce
