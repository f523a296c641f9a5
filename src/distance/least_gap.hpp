#pragma once

/// Compares pairs of triangles by distance, for all searches for the least distance.

#include "distance/pair_search.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Stores the pair with the least distance; of equally near pairs, the one with the lowest numbers.
class LeastGap {
 public:
  LeastGap(const SearchLimits& limits, TriangleGap& best) : limits_(limits), best_(best) {}

  double reach() const {
    if (!is_found_) return limits_.max_distance;
    const double reach = std::sqrt(best_.closest.squared_distance) - limits_.tolerance;
    return reach > 0 ? reach : 0;
  }

  bool keeps_best() const { return true; }
  bool is_done() const { return false; }

  bool wants(const TriangleGap& gap) const {
    return is_found_ ? is_better(gap)
                     : std::sqrt(gap.closest.squared_distance) <= limits_.max_distance;
  }

  void take(const TriangleGap& gap) {
    best_ = gap;
    is_found_ = true;
  }

 private:
  bool is_better(const TriangleGap& gap) const {
    const double squared = gap.closest.squared_distance, best = best_.closest.squared_distance;
    if (squared != best) return squared < best;
    if (gap.triangle_a != best_.triangle_a) return gap.triangle_a < best_.triangle_a;
    return gap.triangle_b < best_.triangle_b;
  }

  const SearchLimits& limits_;
  TriangleGap& best_;
  bool is_found_ = false;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
