#pragma once

/// Lists of the summary of `pelt check`.

#include "tools/pelt/check/touch_tally.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::check {

/// The number of rows that each list shows.
class ListLength {
 public:
  explicit ListLength(std::size_t most) : most_(most) {}

  template <typename Row>
  std::span<const Row> shown(std::span<const Row> rows) const {
    return rows.first(std::min(rows.size(), most_));
  }
  template <typename Row>
  std::span<const Row> shown(const std::vector<Row>& rows) const {
    return shown(std::span<const Row>(rows));
  }

  /// Prints how many of `count` rows the list leaves out, and the option that shows them.
  void print_rest(std::size_t count, std::ostream& out) const;

 private:
  std::size_t most_;
};

/// Width of a column of names.
template <typename Row>
int width_of(std::span<const Row> rows, std::string Row::*column = &Row::a) {
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, (row.*column).size());
  return static_cast<int>(width);
}

/// Contacts by joints or by parts.
struct RowList {
  const char* title;
  const std::vector<TouchTally::Row>& rows;
  std::uint64_t contacts = 0;  ///< in all
  const char* noun = "frame";  ///< what the rows count, and number from 0
};

/// Prints the contacts of each row, its share of all contacts, and its worst frame.
void print_rows(const RowList& list, const scenes::Scene& scene, const ListLength& length,
                std::ostream& out);

}  // namespace pelt::tools::check
