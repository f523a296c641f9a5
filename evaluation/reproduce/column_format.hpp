#pragma once

/// Formats all figures of one column of a table alike.

#include <span>
#include <string>

namespace pelt::reproduce {

/// The format of a column. Whole numbers if all are whole. The same number of decimals in every row
/// if a few decimals represent all figures. Otherwise three significant digits for each figure,
/// with trailing zeros: "0.0182", "4.90", "32.0", "26,756".
class ColumnFormat {
 public:
  explicit ColumnFormat(std::span<const double> figures);

  std::string shown(double figure) const;

 private:
  int decimals_;  // negative: three significant digits
};

}  // namespace pelt::reproduce
