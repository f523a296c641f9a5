#pragma once

#include "tools/pelt/arguments/verb.hpp"

namespace CLI {
class App;
}

namespace pelt::tools::verbs {

/// Adds the verb `reproduce` to `app`. If the command line names the verb, sets `chosen` to its
/// command.
void add_reproduce(CLI::App& app, arguments::Command& chosen);

}  // namespace pelt::tools::verbs
