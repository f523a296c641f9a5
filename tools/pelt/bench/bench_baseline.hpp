#pragma once

/// Figures of an earlier `pelt bench --json`, for comparison with a later run.

#include "tools/pelt/bench/bench_report.hpp"
#include "tools/pelt/bench/figures_reader.hpp"

#include <string_view>

namespace pelt::tools::bench {

using Baseline = BaselineOf<SceneFigures>;

/// `path` is for messages.
Result<Baseline> parse_baseline(const std::string& path, std::string_view text);

Result<Baseline> read_baseline(const std::string& path);

}  // namespace pelt::tools::bench
