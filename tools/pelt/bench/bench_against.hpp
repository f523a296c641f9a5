#pragma once

/// `pelt bench --against`: the ratios of a run beside those of an earlier one. Times depend on the
/// machine, ratios hardly do, so a loss of speed is visible in the ratios on any machine.

#include "tools/pelt/bench/bench_baseline.hpp"

#include <ostream>
#include <span>

namespace pelt::tools::bench {

/// Per cent by which a ratio may be worse without a mark, because of noise: beside other programs,
/// 9 of 128 ratios of an unchanged build were marked, and a smaller margin would mark more.
inline constexpr std::uint32_t kNoisePercent = 15;

struct BenchComparison {
  std::size_t ratios = 0;             ///< measured then and now
  std::size_t worse = 0;              ///< ratios that are worse by more than the margin
  std::size_t different_answers = 0;  ///< queries of scenes
};

/// Prints a table for each scene of `now`, and lists what is missing from `then`. Scenes with other
/// numbers of frames, and queries with other answers, are listed and not compared.
BenchComparison print_comparison(const Baseline& then, std::span<const SceneFigures> now,
                                 std::uint32_t margin_percent, std::ostream& out);

/// The line above the tables of a comparison.
void print_comparison_head(const std::string& path, const Machine& machine, std::ostream& out);

/// The line below them.
void print_comparison_result(const BenchComparison& result, std::uint32_t margin_percent,
                             std::ostream& out);

}  // namespace pelt::tools::bench
