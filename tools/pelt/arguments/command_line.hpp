#pragma once

/// Runs a program with verbs, from its arguments to its exit code: `pelt` and `pelt-lab`.

#include "tools/pelt/arguments/verb.hpp"

namespace pelt::tools::arguments {

struct Program {
  const char* name;
  const char* description;
  const char* footer;  ///< of --help
  /// Adds the verbs. If the command line names a verb, sets `chosen` to its command.
  void (*add_verbs)(CLI::App& app, Command& chosen);
};

/// Reads the command line, runs the verb, and prints its error. Returns the exit code.
int run_command_line(const Program& program, int argc, char** argv);

/// Prepares the streams, signals and memory of the process, then calls `run_command_line`. Call
/// once, in `main`.
int run_process(const Program& program, int argc, char** argv);

}  // namespace pelt::tools::arguments
