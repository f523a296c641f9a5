#pragma once

/// The verbs of the command, each in a file of its own. Every function below adds its verb to
/// `app`; when the command line names the verb, `chosen` becomes what it asks for.

#include "tools/pelt/arguments/exit_code.hpp"

namespace CLI {
class App;
}

namespace pelt::tools::verbs {

void add_check(CLI::App& app, arguments::Command& chosen);
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
void add_reproduce(CLI::App& app, arguments::Command& chosen);  // evaluation/reproduce

}  // namespace pelt::tools::verbs
