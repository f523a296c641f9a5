#pragma once

/// `pelt-lab bench --against`: the ratios of a run beside those of an earlier one. Times depend on
/// the machine, ratios hardly do, so a loss of speed is visible in the ratios on any machine.

#include "evaluation/bench/baseline.hpp"
#include "tools/pelt/bench/figures.hpp"

namespace pelt::lab {

/// Per cent by which a ratio may be worse without a mark, because of noise: beside other programs,
/// 9 of 128 ratios of an unchanged build were marked, and a smaller margin would mark more.
inline constexpr std::uint32_t kNoisePercent = 15;

/// What is compared of a kind of figures.
struct ComparedFigures {
  const FiguresFormat& format;
  const char* unit;               ///< of a scene: "frame"; its number is the value `unit` + "s"
  std::vector<const char*> keys;  ///< identify a row
  tools::bench::Yardsticks yardsticks;

  /// Methods whose rows would repeat the other rows with the opposite meaning: worse if another
  /// method has become faster.
  std::vector<std::string> left_out = {};
};

struct Comparison {
  std::size_t ratios = 0;             ///< measured then and now
  std::size_t worse = 0;              ///< ratios that are worse by more than the margin
  std::size_t different_answers = 0;  ///< queries of scenes
};

/// Prints a table for each scene of `now`, which are scenes of --json, and lists what is missing
/// from `then`. Scenes with other numbers of frames, and queries with other answers, are listed and
/// not compared.
Comparison print_comparison(const ComparedFigures& compared, const Baseline& then,
                            std::span<const tools::bench::Row> now, std::uint32_t margin_percent,
                            std::ostream& out);

}  // namespace pelt::lab
