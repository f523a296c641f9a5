#pragma once

#include "evaluation/methods/lab_methods.hpp"

#include <string>

namespace pelt::reproduce {

/// The name of a method in text, tables and legends of the report. Keys of columns use the name on
/// the command line.
std::string title_of(methods::MethodKind method);

/// Describes the method and names its paper, for readers who do not know the code.
std::string description_of(methods::MethodKind method);

}  // namespace pelt::reproduce
