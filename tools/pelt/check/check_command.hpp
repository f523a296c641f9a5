#pragma once

/// `pelt check` after its arguments are parsed, from the inputs to the exit code. `pelt merge` is
/// the same with frames from shards.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/check_arguments.hpp"
#include "tools/pelt/check/check_run.hpp"

#include <functional>
#include <string>
#include <vector>

namespace pelt::tools::check {

/// Answers of all frames that were found earlier.
struct EarlierAnswers {
  FrameSource source;
  std::vector<std::string> files;  ///< that contain the answers

  /// Returns an error if the answers are not of this scene.
  std::function<Result<void>(const scenes::Scene& scene)> check_scene;
};

/// Checks a scene, writes the outputs and prints the summary. `earlier`: answers to use instead of
/// queries, or null.
Result<arguments::ExitCode> run_check_command(const CheckArguments& arguments,
                                              const EarlierAnswers* earlier = nullptr);

/// Users who forgot a model must not read "no contact" as a clean result.
Error nothing_compared();

}  // namespace pelt::tools::check
