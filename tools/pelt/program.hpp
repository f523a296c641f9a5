#pragma once

#include "tools/pelt/arguments/command_line.hpp"

namespace pelt::tools {

/// The command `pelt`, with all of its verbs.
extern const arguments::Program kPelt;

}  // namespace pelt::tools
