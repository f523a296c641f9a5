#include "tools/pelt/bench/anytime_figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace pelt::tools::bench {
namespace {

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

AnytimeMethodFigures figures_of(const AnytimeBenchMethod& method, const Pairs& pairs, double end) {
  AnytimeMethodFigures figures;
  figures.method = method.name;
  figures.title = method.title;
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

std::vector<AnytimeMethodFigures> figures_of(std::span<const AnytimeBenchMethod> methods,
                                             std::span<const AnytimeRecord> records,
                                             std::size_t unit) {
  std::vector<Pairs> all;
  for (const AnytimeRecord& record : records) all.emplace_back(record.curves, records[unit].curves);
  double end = 1;
  for (const Pairs& pairs : all) end = std::max(end, pairs.end());
  std::vector<AnytimeMethodFigures> figures;
  for (std::size_t m = 0; m < methods.size(); ++m)
    figures.push_back(figures_of(methods[m], all[m], end));
  return figures;
}

const AnytimeMethodFigures* find_method(const AnytimeSceneFigures& scene, std::string_view method) {
  const auto found =
      std::find_if(scene.methods.begin(), scene.methods.end(),
                   [&](const AnytimeMethodFigures& m) { return m.method == method; });
  return found == scene.methods.end() ? nullptr : &*found;
}

}  // namespace pelt::tools::bench
