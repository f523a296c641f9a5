#pragma once

/// `pelt check --shard`.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/options.hpp"

namespace pelt::tools::shard {

/// Queries the frames of a shard, or checks its scenes, and writes its file.
Result<arguments::ExitCode> run_shard(const check::CheckOptions& options);

}  // namespace pelt::tools::shard
