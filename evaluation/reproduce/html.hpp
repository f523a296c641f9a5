#pragma once

/// The report as a single self-contained page, and the format of the figures in its tables.

#include "evaluation/reproduce/report.hpp"

#include <map>
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

/// The page. `images` has the bytes of charts (SVG) and pictures (PNG) by id; the page says which
/// are missing. `provenance` has lines about machine, build and date.
std::string html_page(const std::vector<Section>& sections,
                      const std::vector<std::string>& provenance,
                      const std::map<std::string, std::string>& images);

}  // namespace pelt::reproduce
