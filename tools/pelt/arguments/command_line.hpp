#pragma once

/// What a program with verbs does from its arguments to its exit code: `pelt`, and `pelt-lab` too.

#include "tools/pelt/arguments/exit_code.hpp"

namespace CLI {
class App;
}

namespace pelt::tools::arguments {

struct Program {
  const char* name;
  const char* description;
  const char* footer;  ///< of --help
  /// Adds the verbs. When the command line names one, `chosen` becomes what it asks for.
  void (*add_verbs)(CLI::App& app, Command& chosen);
};

/// Reads the command line, runs the verb, and prints what went wrong. Returns the exit code of the
/// process.
int run_command_line(const Program& program, int argc, char** argv);

}  // namespace pelt::tools::arguments
