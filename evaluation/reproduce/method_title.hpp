#pragma once

#include "evaluation/methods/lab_methods.hpp"

#include <string>

namespace pelt::reproduce {

/// What the report calls a method, in text, tables and legends alike; keys of columns keep the
/// name that the command line has for it.
std::string title_of(methods::MethodKind method);

/// What it does and where it is from, for those who have not read the code.
std::string description_of(methods::MethodKind method);

}  // namespace pelt::reproduce
