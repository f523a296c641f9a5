#pragma once

/// The command `pelt`, and its verbs, each in a file of its own. Each function adds its verb to
/// `app`; if the command line names the verb, sets `chosen` to its command. `check` and `merge` get
/// the methods of the program.

#include "tools/pelt/arguments/command_line.hpp"
#include "tools/pelt/methods/method.hpp"

namespace pelt::tools::verbs {

/// The program with all verbs.
extern const arguments::Program kPelt;

void add_check(CLI::App& app, arguments::Command& chosen, methods::MethodKinds known_methods);
void add_merge(CLI::App& app, arguments::Command& chosen, methods::MethodKinds known_methods);
void add_view(CLI::App& app, arguments::Command& chosen);
void add_bounds(CLI::App& app, arguments::Command& chosen);
void add_distance(CLI::App& app, arguments::Command& chosen);
void add_ray(CLI::App& app, arguments::Command& chosen);
void add_region(CLI::App& app, arguments::Command& chosen);
void add_info(CLI::App& app, arguments::Command& chosen);
void add_prepare(CLI::App& app, arguments::Command& chosen);
void add_pose(CLI::App& app, arguments::Command& chosen);
void add_demo(CLI::App& app, arguments::Command& chosen);
void add_bench(CLI::App& app, arguments::Command& chosen);

}  // namespace pelt::tools::verbs
