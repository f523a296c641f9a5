#pragma once

/// The summary of `pelt check`.

#include "tools/pelt/check/report.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
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

void print_summary(const Stage& stage, const CheckReport& report, const TouchTally& tally,
                   std::ostream& out);

}  // namespace pelt::tools::check
