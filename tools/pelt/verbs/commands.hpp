#pragma once

/// The verbs of the command, each in a file of its own. `check` and `bench` get the methods that
/// the program offers. Every function below adds its verb to `app`; when the command line names the
/// verb, `chosen` becomes what it asks for.

#include "tools/pelt/arguments/exit_code.hpp"
#include "tools/pelt/methods/method.hpp"

#include <string>

namespace CLI {
class App;
}

namespace pelt::tools::verbs {

/// The methods of a `bench`.
struct BenchMethods {
  methods::MethodKinds known;  ///< what --methods can name; must outlive the command
  const char* measured;        ///< by default: names with commas between them
  std::string notes;           ///< to --help, below all that holds for any methods
};

void add_check(CLI::App& app, arguments::Command& chosen, methods::MethodKinds known_methods);
void add_view(CLI::App& app, arguments::Command& chosen);
void add_bounds(CLI::App& app, arguments::Command& chosen);
void add_distance(CLI::App& app, arguments::Command& chosen);
void add_ray(CLI::App& app, arguments::Command& chosen);
void add_region(CLI::App& app, arguments::Command& chosen);
void add_info(CLI::App& app, arguments::Command& chosen);
void add_prepare(CLI::App& app, arguments::Command& chosen);
void add_pose(CLI::App& app, arguments::Command& chosen);
void add_demo(CLI::App& app, arguments::Command& chosen);
void add_bench(CLI::App& app, arguments::Command& chosen, const BenchMethods& methods);

}  // namespace pelt::tools::verbs
