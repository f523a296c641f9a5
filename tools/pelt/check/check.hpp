#pragma once

/// `pelt check` of one scene, from its options to the exit code. `pelt merge` is the same with
/// frames from shards.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/frame_query.hpp"
#include "tools/pelt/check/report.hpp"
#include "tools/pelt/check/settings.hpp"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::check {

/// Passes the answers of all frames of a check to `use`, in order. Returns the first error.
using FrameSource = std::function<Result<void>(const Stage& stage, const UseAnswer& use)>;

/// A checked scene.
struct CheckAnswer {
  Stage stage;
  TouchTally tally;
  CheckReport report;
};

/// Gets the answers of all frames from `source`, or, if it is empty, queries the frames on the
/// threads of the settings. Writes all lines of --jsonl, unless `lines` is null, and prints only
/// the progress bar. Scene and settings must outlive the answer.
Result<CheckAnswer> answer_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                 const FrameSource& source, std::ostream* lines);

/// Answers a scene, writes the outputs that the options of the settings name, and prints the
/// summary to `words`. `pelt demo` uses it, too.
Result<CheckReport> check_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                std::ostream& words, const FrameSource& source = nullptr);

/// Answers of all frames that were found earlier.
struct EarlierAnswers {
  FrameSource source;
  std::vector<std::string> files;  ///< that contain the answers

  /// Returns an error if the answers are not of this scene.
  std::function<Result<void>(const scenes::Scene& scene)> check_scene;
};

/// Checks the scene of the options. `earlier`: answers to use instead of queries, or null.
Result<arguments::ExitCode> run_check(const CheckOptions& options,
                                      const EarlierAnswers* earlier = nullptr);

/// Returns an error if a check has compared nothing, unless the settings allow this: users who
/// forgot a model must not read "no contact" as a clean result.
Result<void> require_comparison(const CheckReport& report, const CheckSettings& settings);

}  // namespace pelt::tools::check
