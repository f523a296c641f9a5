#pragma once

/// `pelt bench --moving --against`: the ratios of a run beside those of an earlier one.

#include "tools/pelt/bench/bench_against.hpp"
#include "tools/pelt/bench/moving_report.hpp"

#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace pelt::tools::bench {

/// Figures of an earlier `pelt bench --moving --json`.
struct MovingBaseline {
  std::string path;  ///< as given by the user
  Machine machine;
  std::vector<MovingSceneFigures> scenes;  ///< only compared values: names, steps, hashes, means
};

/// `path` is for messages.
Result<MovingBaseline> parse_moving_baseline(const std::string& path, std::string_view text);

Result<MovingBaseline> read_moving_baseline(const std::string& path);

/// Prints a table for each scene of `now`, and lists what is missing from `then`. Scenes with other
/// numbers of steps, and queries with other answers, are listed and not compared.
BenchComparison print_moving_comparison(const MovingBaseline& then,
                                        std::span<const MovingSceneFigures> now,
                                        std::uint32_t margin_percent, std::ostream& out);

}  // namespace pelt::tools::bench
