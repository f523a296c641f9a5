#pragma once

/// Runs `pelt check` after its arguments: makes colliders, runs through the frames, writes the
/// files and prints the summary. `pelt demo` uses it too.

#include "tools/pelt/check/check_run.hpp"
#include "tools/pelt/output/output_file.hpp"

#include <ostream>
#include <string>

namespace pelt::tools::check {

struct CheckOutputs {
  std::string jsonl;  ///< file, kStandardOutput or "" for none
  std::string glb;    ///< file for the frame that is kept, or "" for none
  std::string html;   ///< file for the report, or "" for none
  std::string words;  ///< command line of the report
};

/// Finds the answer of a scene and writes all lines of --jsonl, unless `lines` is null. For the
/// other arguments, see run_check.
Result<CheckReport> answer_scene(const scene::StagedScene& staged, const CheckSettings& settings,
                                 const CheckQuestion& question, const FrameSource& source,
                                 TouchTally& tally, std::ostream* lines);

/// Prints the summary to `words`. `source`: see run_check.
Result<CheckReport> check_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                const arguments::ModelArguments& models,
                                const CheckOutputs& outputs, std::ostream& words,
                                const FrameSource& source = nullptr);

}  // namespace pelt::tools::check
