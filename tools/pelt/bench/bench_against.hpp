#pragma once

/// `pelt bench --against`: the ratios of a run beside those of an earlier one. Times are of their
/// machine, ratios carry over; so a change that costs speed is seen in them wherever it is
/// measured.

#include "tools/pelt/bench/bench_baseline.hpp"

#include <ostream>
#include <span>

namespace pelt::tools {

/// By how many hundredths a ratio may be worse before it is marked. It is for noise: beside other
/// programs 9 of 128 ratios of the very same build were marked, more would be at less.
inline constexpr std::uint32_t kNoisePercent = 15;

struct BenchComparison {
  std::size_t ratios = 0;             ///< measured then and now
  std::size_t worse = 0;              ///< ratios that are worse by more than the margin
  std::size_t different_answers = 0;  ///< questions of scenes
};

/// Prints a table for each scene of `now`, and what `then` lacks of it. Scenes of other lengths,
/// and questions that were answered otherwise, are named instead of compared.
BenchComparison print_comparison(const Baseline& then, std::span<const SceneFigures> now,
                                 std::uint32_t margin_percent, std::ostream& out);

}  // namespace pelt::tools
