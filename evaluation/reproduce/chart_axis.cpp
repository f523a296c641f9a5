#include "evaluation/reproduce/chart_axis.hpp"

#include "text/format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pelt::reproduce {
namespace {

/// Fraction of the axis' length, at both ends.
constexpr double kMargin = 0.03;

struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void include(double figure) {
    low = std::min(low, figure);
    high = std::max(high, figure);
  }
  bool is_empty() const { return low > high; }
};

std::string number(double figure) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", figure);
  return text;
}

std::string range(const std::string& axis, const Range& of) {
  return "set " + axis + "range [" + number(of.low) + ":" + number(of.high) + "]\n";
}

/// A number without an exponent: "0.05", "1,000,000".
std::string label(double figure) {
  return figure < 1 ? number(figure)
                    : text::with_commas(static_cast<std::uint64_t>(std::llround(figure)));
}

/// Whether `digit` (1 to 9) times a power of ten has a label. With fewer decades, more tics have
/// labels.
bool has_label(int digit, double decades) {
  if (digit == 1) return true;
  return decades < 1 || (decades < 2.5 && (digit == 2 || digit == 5));
}

}  // namespace

std::string linear_axis(const std::string& axis, std::span<const double> figures) {
  Range all;
  for (const double figure : figures) all.include(figure);
  if (all.is_empty()) return "";
  const double span = all.high > all.low ? all.high - all.low : 1;
  return range(axis, {all.low - kMargin * span, all.high + kMargin * span});
}

std::string axis_from(const std::string& axis, double from) {
  return "set " + axis + "range [" + number(from) + ":*]\n";
}

std::string logarithmic_axis(const std::string& axis, std::span<const double> figures) {
  Range all;
  for (const double figure : figures)
    if (figure > 0) all.include(figure);
  const std::string scale = "set logscale " + axis + "\n";
  if (all.is_empty()) return scale;
  const double decades = std::max(std::log10(all.high / all.low), 0.3);
  const double margin = std::pow(10, kMargin * decades);
  const Range shown = {all.low / margin, all.high * margin};
  std::string tics;
  for (double power = std::pow(10, std::floor(std::log10(shown.low))); power <= shown.high;
       power *= 10)
    for (int digit = 1; digit <= 9; ++digit) {
      const double at = digit * power;
      if (at < shown.low || at > shown.high) continue;
      const bool is_major = has_label(digit, decades);
      tics += (tics.empty() ? "'" : ", '") + (is_major ? label(at) : "") + "' " + number(at) +
              (is_major ? " 0" : " 1");
    }
  return scale + range(axis, shown) + "set " + axis + "tics (" + tics + ")\n";
}

}  // namespace pelt::reproduce
