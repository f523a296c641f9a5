#pragma once

/// What `pelt bench --json` wrote once, read again to compare a later run with it.

#include "tools/pelt/bench/bench_report.hpp"
#include "tools/pelt/bench/machine.hpp"

#include <string_view>

namespace pelt::tools {

struct Baseline {
  std::string path;  ///< as the user named it
  Machine machine;
  std::vector<SceneFigures> scenes;  ///< of these what is compared: names, frames, hashes, means
};

/// `path` is for messages.
Result<Baseline> parse_baseline(const std::string& path, std::string_view text);

Result<Baseline> read_baseline(const std::string& path);

}  // namespace pelt::tools
