#pragma once

/// Figures of an earlier run, read from a file of --json. Errors name the file, the value and the
/// remedy.
///
/// `pelt-lab bench --against`: the ratios of a run beside those of an earlier one. Times depend on
/// the machine, ratios hardly do, so a loss of speed is visible in the ratios on any machine.

#include <pelt/result.hpp>

#include "tools/pelt/bench/figures.hpp"
#include "tools/pelt/bench/machine.hpp"

#include <string_view>

namespace pelt::lab {

/// A value that is compared.
struct Field {
  enum class Kind {
    text,   ///< not empty
    name,   ///< one of `names`
    count,  ///< a whole number
    hash,   ///< 16 hexadecimal digits
    time,   ///< positive, because it is a divisor
  };

  const char* name;
  Kind kind;
  std::vector<const char*> names = {};
  const char* former = nullptr;  ///< name in version 0.1, if it was another
};

/// A kind of file.
struct FiguresFormat {
  const char* name;     ///< the value of `format`
  const char* command;  ///< which writes it
  std::vector<Field> scene, method;
};

/// The format of `pelt bench` and `pelt-lab bench`.
extern const FiguresFormat kFramesFormat;

/// The format of `pelt-lab bench --moving`.
extern const FiguresFormat kStepsFormat;

struct Baseline {
  std::string path;  ///< as given by the user
  tools::bench::Machine machine;
  std::vector<tools::bench::Row> scenes;  ///< only compared values, and the rows "methods"
};

/// `path` is for messages.
Result<Baseline> parse_baseline(const std::string& path, std::string_view text,
                                const FiguresFormat& format);

Result<Baseline> read_baseline(const std::string& path, const FiguresFormat& format);

/// Per cent by which a ratio may be worse without a mark, because of noise: beside other programs,
/// 9 of 128 ratios of an unchanged build were marked, and a smaller margin would mark more.
inline constexpr std::uint32_t kNoisePercent = 15;

/// Names the values of a kind of figures that are compared.
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
