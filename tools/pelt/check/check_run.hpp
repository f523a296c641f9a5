#pragma once

/// Core of `pelt check`: finds the contacts of every frame of a scene.

#include "tools/pelt/check/check_record.hpp"

#include <functional>

namespace pelt::tools::check {

/// Uses the answer of a frame.
using UseAnswer = std::function<Result<void>(const FrameAnswer& answer)>;

/// Passes the answers of all frames of a check to `use`, in order. Returns the first error.
using FrameSource = std::function<Result<void>(
    const scene::StagedScene& staged, const CheckSettings& settings, const UseAnswer& use)>;

/// Gets the answers of all frames from `source`, or, if it is empty, queries the frames on the
/// threads of the settings. Writes lines to `jsonl`, and prints only the
/// progress bar. The answer does not depend on the number of threads. Memory: a query for each
/// thread, and the answers of a few frames.
Result<CheckReport> run_check(const scene::StagedScene& staged, const CheckSettings& settings,
                              const CheckQuestion& question, const FrameSource& source,
                              TouchTally& tally, JsonlWriter& jsonl);

}  // namespace pelt::tools::check
