#pragma once

/// What a method of `pelt bench --anytime` knows about two instances, over its work and over time.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::bench {

/// What is known at one moment.
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

}  // namespace pelt::tools::bench
