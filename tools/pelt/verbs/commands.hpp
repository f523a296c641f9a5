#pragma once

/// The verbs of the command, each in a file of its own. Each function adds its verb to `app`; if
/// the command line names the verb, sets `chosen` to its command. `check` and `bench` get the
/// methods of the program.

#include "tools/pelt/arguments/exit_code.hpp"
#include "tools/pelt/methods/anytime_method.hpp"
#include "tools/pelt/methods/method.hpp"
#include "tools/pelt/methods/moving_method.hpp"

#include <string>

namespace CLI {
class App;
}

namespace pelt::tools::verbs {

/// The methods of a `bench`.
struct BenchMethods {
  /// Possible values of --methods, and its default, separated by commas.
  struct Choice {
    methods::MethodKinds known;  ///< must outlive the command
    std::string measured;
  };

  /// The same for --moving.
  struct MovingChoice {
    methods::MovingMethodKinds known;
    std::string measured;
  };

  /// The same for --anytime.
  struct AnytimeChoice {
    methods::AnytimeMethodKinds known;
    std::string measured;
  };

  Choice pairs;           ///< for pairs of instances
  Choice self;            ///< for an instance against itself
  MovingChoice moving;    ///< for pairs of instances between frames
  AnytimeChoice anytime;  ///< for searches that are stopped
  std::string notes;      ///< added to --help after the text for all methods
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
