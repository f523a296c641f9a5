#include "evaluation/reproduce/report.hpp"

#include "base/assert.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::reproduce {

std::size_t column_of(const Table& table, const std::string& key) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.key == key; });
  PELT_ASSERT(found != table.columns.end());
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// Whole numbers in full, others with at least three digits.
std::string shown(double figure) {
  const double size = std::fabs(figure);
  if (size >= 100 || figure == std::floor(figure))
    return (figure < 0 ? "-" : "") + text::with_commas(static_cast<std::uint64_t>(size + 0.5));
  int decimals = 2;
  for (double digit = 1; digit > 1e-6 && size < digit; digit /= 10) ++decimals;
  return text::fixed(figure, size >= 10 ? 1 : decimals);
}

std::string shown(const Cell& cell) { return cell.figure ? shown(*cell.figure) : cell.name; }

}  // namespace pelt::reproduce
