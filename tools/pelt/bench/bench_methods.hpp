#pragma once

/// The methods of a program with the verb `bench`.

#include "tools/pelt/methods/anytime_method.hpp"
#include "tools/pelt/methods/method.hpp"
#include "tools/pelt/methods/moving_method.hpp"

#include <string>

namespace pelt::tools::bench {

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

}  // namespace pelt::tools::bench
