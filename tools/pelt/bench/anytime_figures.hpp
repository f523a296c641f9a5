#pragma once

/// Figures of `pelt bench --anytime`: means over all pairs of instances in contact. Times are
/// relative to the time of a complete search of the same pair in the order `contacts`.

#include "tools/pelt/bench/anytime_measure.hpp"

#include <string>
#include <vector>

namespace pelt::tools::bench {

/// Shares of the work, or of the time of a complete search.
inline constexpr std::array kAnytimeRungs = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

/// What is known on average.
struct AnytimeRung {
  double share = 0;  ///< of the work or of the time
  double time = 0;   ///< relative to a complete search; equal to `share` if that is of the time
  AnytimePoint known;
};

/// Figures of one method.
struct AnytimeMethodFigures {
  std::string method, title;
  double work = 0;         ///< units, to the end
  double complete_us = 0;  ///< time to the end
  std::uint64_t longest_step = 0;
  double area_over_work = 0, area_over_time = 0;
  std::vector<AnytimeRung> over_work;  ///< [kAnytimeRungs]
  std::vector<AnytimeRung> over_time;  ///< [kAnytimeRungs]

  /// The same at many times, in equal steps of the logarithm, until all methods are complete.
  std::vector<AnytimeRung> course;
};

struct AnytimeSceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t frames = 0;     ///< with contact
  std::uint64_t pairs = 0;      ///< pairs of instances in contact, in all frames
  std::uint64_t contacts = 0;   ///< of all pairs
  std::uint64_t hash = 0;       ///< of all contacts, as in `pelt check`
  std::uint32_t repetitions = 0;
  double collide_us = 0;
  std::vector<AnytimeMethodFigures> methods;  ///< not empty
};

/// The figures of all methods, from their records [methods]. `unit` is the index of the order
/// `contacts`. Precondition: at least one case.
std::vector<AnytimeMethodFigures> figures_of(std::span<const AnytimeBenchMethod> methods,
                                             std::span<const AnytimeRecord> records,
                                             std::size_t unit);

/// The figures of a method, or null.
const AnytimeMethodFigures* find_method(const AnytimeSceneFigures& scene, std::string_view method);

}  // namespace pelt::tools::bench
