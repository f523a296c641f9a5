#pragma once

#include "tools/pelt/arguments/exit_code.hpp"

namespace CLI {
class App;
}

namespace pelt::tools::verbs {

/// Adds the verb `reproduce` to `app`; when the command line names it, `chosen` becomes what it
/// asks for.
void add_reproduce(CLI::App& app, arguments::Command& chosen);

}  // namespace pelt::tools::verbs
