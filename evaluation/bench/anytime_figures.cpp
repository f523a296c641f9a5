#include "evaluation/bench/anytime_figures.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::lab {
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

constexpr int kStepsPerDecade = 30;

/// The curves of one method, and the times of complete searches of the same pairs.
class Pairs {
 public:
  Pairs(std::span<const AnytimeCurve> curves, std::span<const AnytimeCurve> units)
      : curves_(curves), units_(units) {}

  /// Mean of `value(curve, time of a complete search)`.
  template <typename Value>
  auto mean(const Value& value) const {
    auto sum = value(curves_[0], units_[0].complete_us());
    for (std::size_t c = 1; c < curves_.size(); ++c)
      sum = sum + value(curves_[c], units_[c].complete_us());
    return sum / static_cast<double>(curves_.size());
  }

  AnytimeRung after_work(double share) const {
    return {share,
            mean([&](const AnytimeCurve& c, double unit) { return c.time_us(share) / unit; }),
            mean([&](const AnytimeCurve& c, double) { return c.at_work(share); })};
  }

  AnytimeRung after_time(double share) const {
    return {share, share,
            mean([&](const AnytimeCurve& c, double unit) { return c.at_time(share * unit); })};
  }

  /// The time after which the searches of all pairs are complete.
  double end() const {
    double end = 1;
    for (std::size_t c = 0; c < curves_.size(); ++c)
      end = std::max(end, curves_[c].complete_us() / units_[c].complete_us());
    return end;
  }

  std::uint64_t longest_step() const {
    std::uint64_t longest = 0;
    for (const AnytimeCurve& curve : curves_) longest = std::max(longest, curve.longest_step);
    return longest;
  }

 private:
  std::span<const AnytimeCurve> curves_, units_;
};

AnytimeMethodFigures figures_of(const AnytimeRecord& record, const Pairs& pairs, double end) {
  AnytimeMethodFigures figures;
  figures.method = record.method;
  figures.title = record.title;
  figures.work =
      pairs.mean([](const AnytimeCurve& c, double) { return static_cast<double>(c.work); });
  figures.complete_us = pairs.mean([](const AnytimeCurve& c, double) { return c.complete_us(); });
  figures.longest_step = pairs.longest_step();
  figures.area_over_work =
      pairs.mean([](const AnytimeCurve& c, double) { return area_over_work(c); });
  figures.area_over_time = pairs.mean(area_over_time);
  for (const double share : kAnytimeRungs) {
    figures.over_work.push_back(pairs.after_work(share));
    figures.over_time.push_back(pairs.after_time(share));
  }
  const int last = static_cast<int>(std::ceil(kStepsPerDecade * std::log10(end)));
  for (int step = -2 * kStepsPerDecade; step <= last; ++step)
    figures.course.push_back(
        pairs.after_time(std::pow(10, static_cast<double>(step) / kStepsPerDecade)));
  return figures;
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

std::vector<AnytimeMethodFigures> figures_of(std::span<const AnytimeRecord> records,
                                             std::size_t unit) {
  std::vector<Pairs> all;
  double end = 1;
  for (const AnytimeRecord& record : records) {
    all.emplace_back(record.curves, records[unit].curves);
    end = std::max(end, all.back().end());
  }
  std::vector<AnytimeMethodFigures> figures;
  for (std::size_t m = 0; m < records.size(); ++m)
    figures.push_back(figures_of(records[m], all[m], end));
  return figures;
}

const AnytimeMethodFigures* find_method(const AnytimeSceneFigures& scene, std::string_view method) {
  const auto found =
      std::find_if(scene.methods.begin(), scene.methods.end(),
                   [&](const AnytimeMethodFigures& m) { return m.method == method; });
  return found == scene.methods.end() ? nullptr : &*found;
}

}  // namespace pelt::lab
