#pragma once

/// Figures of an earlier `pelt bench --moving --json`, for comparison with a later run.

#include "tools/pelt/bench/figures_reader.hpp"
#include "tools/pelt/bench/moving_report.hpp"

#include <string_view>

namespace pelt::tools::bench {

using MovingBaseline = BaselineOf<MovingSceneFigures>;

/// `path` is for messages.
Result<MovingBaseline> parse_moving_baseline(const std::string& path, std::string_view text);

Result<MovingBaseline> read_moving_baseline(const std::string& path);

}  // namespace pelt::tools::bench
