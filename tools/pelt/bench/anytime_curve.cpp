#include "tools/pelt/bench/anytime_curve.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::tools::bench {
namespace {

/// Mean of `value(x)` for x from 0 to 1, by the trapezoidal rule.
template <typename Value>
double area_of(const Value& value) {
  double sum = (value(0.0) + value(1.0)) / 2;
  for (std::size_t i = 1; i < kAnytimeSlices; ++i)
    sum += value(static_cast<double>(i) / kAnytimeSlices);
  return sum / kAnytimeSlices;
}

/// std::lerp, unlike a weighted sum, never decreases where both ends are alike or increase.
AnytimePoint between(const AnytimePoint& a, const AnytimePoint& b, double part) {
  return {std::lerp(a.listed, b.listed, part), std::lerp(a.undecided, b.undecided, part),
          std::lerp(a.resolution, b.resolution, part)};
}

}  // namespace

AnytimePoint operator+(const AnytimePoint& a, const AnytimePoint& b) {
  return {a.listed + b.listed, a.undecided + b.undecided, a.resolution + b.resolution};
}

AnytimePoint operator/(const AnytimePoint& point, double divisor) {
  return {point.listed / divisor, point.undecided / divisor, point.resolution / divisor};
}

AnytimePoint AnytimeCurve::at_work(double share) const {
  const double slice = share * kAnytimeSlices;
  const std::size_t before = std::min(static_cast<std::size_t>(slice), kAnytimeSlices - 1);
  const double part = slice - static_cast<double>(before);
  return between(points[before], points[before + 1], part);
}

double AnytimeCurve::time_us(double share) const {
  std::size_t after = 1;
  while (after + 1 < kTimedShares.size() && kTimedShares[after] < share) ++after;
  const double begin = kTimedShares[after - 1], end = kTimedShares[after];
  const double part = (share - begin) / (end - begin);
  return std::lerp(times_us[after - 1], times_us[after], part);
}

/// Noise can make the time of a share less than that of a smaller share. Of several shares with
/// this time, takes the greatest.
AnytimePoint AnytimeCurve::at_time(double us) const {
  std::size_t last = kTimedShares.size() - 1;
  while (last > 0 && times_us[last] > us) --last;
  if (times_us[last] > us) return points[0];
  if (last + 1 == kTimedShares.size()) return points[kAnytimeSlices];
  const double part = (us - times_us[last]) / (times_us[last + 1] - times_us[last]);
  return at_work(std::lerp(kTimedShares[last], kTimedShares[last + 1], part));
}

double area_over_work(const AnytimeCurve& curve) {
  return area_of([&](double share) { return curve.at_work(share).listed; });
}

double area_over_time(const AnytimeCurve& curve, double end_us) {
  return area_of([&](double share) { return curve.at_time(share * end_us).listed; });
}

}  // namespace pelt::tools::bench
