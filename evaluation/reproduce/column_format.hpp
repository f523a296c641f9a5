#pragma once

/// Figures of one column of a table, all written alike.

#include <span>
#include <string>

namespace pelt::reproduce {

/// How the figures of a column are written: whole numbers where all are whole; as many decimals in
/// every row where a few tell all of them; otherwise three significant digits of each, with the
/// zeros at their ends: "0.0182", "4.90", "32.0", "26,756".
class ColumnFormat {
 public:
  explicit ColumnFormat(std::span<const double> figures);

  std::string shown(double figure) const;

 private:
  int decimals_;  // negative: three significant digits
};

}  // namespace pelt::reproduce
