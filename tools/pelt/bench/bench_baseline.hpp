#pragma once

/// Figures of an earlier `pelt bench --json`, for comparison with a later run.

#include "tools/pelt/bench/bench_report.hpp"
#include "tools/pelt/bench/machine.hpp"

#include <string_view>

namespace pelt::tools::bench {

struct Baseline {
  std::string path;  ///< as given by the user
  Machine machine;
  std::vector<SceneFigures> scenes;  ///< only compared values: names, frames, hashes, means
};

/// `path` is for messages.
Result<Baseline> parse_baseline(const std::string& path, std::string_view text);

Result<Baseline> read_baseline(const std::string& path);

}  // namespace pelt::tools::bench
