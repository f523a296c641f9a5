#pragma once

/// The results of methods of `pelt-lab bench --anytime` over their work and over time: curves of
/// single pairs of instances, and means over all pairs in contact. Times are relative to the time
/// of a complete search of the same pair in the order `contacts`. The chart of these curves.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::lab {

/// The state of a search at one moment.
struct AnytimePoint {
  double listed = 0;      ///< share of the contacts that are found
  double undecided = 0;   ///< share of the pairs of triangles that are not decided
  double resolution = 0;  ///< longest side of an open region, in model units
};

AnytimePoint operator+(const AnytimePoint& a, const AnytimePoint& b);
AnytimePoint operator/(const AnytimePoint& point, double divisor);

/// Number of equal shares of the work after which the state is recorded.
inline constexpr std::size_t kAnytimeSlices = 200;

/// The shares of the work for which the time is measured. Between them, time is taken to grow in
/// proportion to work.
inline constexpr std::array kTimedShares = {0.0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0};

/// One case of one method.
struct AnytimeCurve {
  std::array<AnytimePoint, kAnytimeSlices + 1> points;  ///< after i / kAnytimeSlices of the work
  std::uint64_t work = 0, longest_step = 0;             ///< units
  std::array<double, kTimedShares.size()> times_us = {};

  /// Precondition: 0 <= share <= 1.
  AnytimePoint at_work(double share) const;

  /// The time that a share of the work takes. Precondition: 0 <= share <= 1.
  double time_us(double share) const;

  AnytimePoint at_time(double us) const;

  double complete_us() const { return times_us.back(); }
};

/// Area under the share of contacts listed over the share of the work: 1 if all contacts are listed
/// at once, 0 if all are listed at the end.
double area_over_work(const AnytimeCurve& curve);

/// The same over the time from 0 to `end_us`.
double area_over_time(const AnytimeCurve& curve, double end_us);

/// The results of a method in all cases.
struct AnytimeRecord {
  std::string method, title;
  std::vector<AnytimeCurve> curves;  ///< [cases]
  std::uint64_t hash = 0;            ///< of the contacts when complete, as of `collide`
};

// --- means over all pairs

/// Shares of the work, or of the time of a complete search.
inline constexpr std::array kAnytimeRungs = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

/// The mean state of a search.
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

/// The figures of all methods, from their records. `unit` is the index of the order `contacts`.
/// Precondition: at least one case.
std::vector<AnytimeMethodFigures> figures_of(std::span<const AnytimeRecord> records,
                                             std::size_t unit);

/// The figures of a method, or null.
const AnytimeMethodFigures* find_method(const AnytimeSceneFigures& scene, std::string_view method);

/// The chart as SVG: what is known over the time, a row of panels for each scene. The methods of
/// all scenes must be the same. Precondition: not empty.
std::string anytime_chart(const std::vector<AnytimeSceneFigures>& scenes);

}  // namespace pelt::lab
