#pragma once

#include <pelt/query.hpp>

namespace pelt::detail {

/// The answer of a query that stops at its first result. Stopping there is the regular end, so
/// nothing was cut short.
inline YesNo yes_or_no(bool answer, const QueryStats& stats) {
  YesNo result = {stats, answer};
  result.cut_short = false;
  return result;
}

}  // namespace pelt::detail
