#pragma once

/// `pelt bench --moving --against`: the ratios of a run beside those of an earlier one.

#include "tools/pelt/bench/bench_against.hpp"
#include "tools/pelt/bench/moving_baseline.hpp"

#include <ostream>
#include <span>

namespace pelt::tools::bench {

/// Prints a table for each scene of `now`, and lists what is missing from `then`. Scenes with other
/// numbers of steps, and queries with other answers, are listed and not compared.
BenchComparison print_moving_comparison(const MovingBaseline& then,
                                        std::span<const MovingSceneFigures> now,
                                        std::uint32_t margin_percent, std::ostream& out);

}  // namespace pelt::tools::bench
