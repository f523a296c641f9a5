#include "evaluation/reproduce/column_format.hpp"

#include "text/format.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::reproduce {
namespace {

constexpr int kSignificant = 3;
constexpr int kMaxDecimals = 6;

/// Number of digits before the decimal point, minus one, of the figure rounded to three digits: 0
/// for 1 to 9.99.
int magnitude(double figure) { return static_cast<int>(std::floor(std::log10(1.0005 * figure))); }

bool has_decimals(double figure, int decimals) {
  const double shifted = figure * std::pow(10, decimals);
  return std::fabs(shifted - std::round(shifted)) <= 1e-9 * std::max(1.0, std::fabs(shifted));
}

int decimals_of(double figure) {
  int decimals = 0;
  while (decimals < kMaxDecimals && !has_decimals(figure, decimals)) ++decimals;
  return decimals;
}

/// Decimals for three significant digits.
int significant_decimals(double figure) {
  return std::clamp(kSignificant - 1 - magnitude(figure), 0, kMaxDecimals);
}

/// "-1,234.50"
std::string with_decimals(double figure, int decimals) {
  const std::string digits = text::fixed(std::fabs(figure), decimals);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  return (figure < 0 ? "-" : "") + text::with_commas(std::stoull(digits.substr(0, point))) +
         digits.substr(point);
}

}  // namespace

ColumnFormat::ColumnFormat(std::span<const double> figures) : decimals_(0) {
  double least = HUGE_VAL, most = 0;
  int exact = 0;
  for (const double figure : figures) {
    exact = std::max(exact, decimals_of(figure));
    if (figure == 0) continue;
    least = std::min(least, std::fabs(figure));
    most = std::max(most, std::fabs(figure));
  }
  if (exact == 0) return;
  decimals_ = std::min(exact, significant_decimals(least));
  const bool is_aligned = magnitude(most) + 1 + decimals_ <= kSignificant + 1;
  if (!is_aligned) decimals_ = -1;
}

std::string ColumnFormat::shown(double figure) const {
  if (decimals_ >= 0) return with_decimals(figure, decimals_);
  return figure == 0 ? "0" : with_decimals(figure, significant_decimals(std::fabs(figure)));
}

}  // namespace pelt::reproduce
