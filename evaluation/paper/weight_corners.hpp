#pragma once

/// Kavan & Zara 2005, section 4.1: the corners of the clipped weight simplex
///
///     W' = { w : l_i <= w_i <= h_i, w_1 + ... + w_n = 1 },
///
/// whose convex combinations are all of W'. They are constants of the model.

#include <span>
#include <vector>

namespace pelt::paper {

/// <l, h>: all weights that one joint has among some vertices.
struct WeightInterval {
  double low = 1, high = 0;

  void include(double weight) {
    if (weight < low) low = weight;
    if (weight > high) high = weight;
  }
};

/// Up to this many joints the corners are enumerated; a set of more joints would have thousands and
/// gets the n corners l + (1 - sum l) e_a instead, whose hull contains W'.
inline constexpr std::size_t kMaxEnumeratedJoints = 8;

/// Sums of weights are off 1 by rounding, so corners may leave their intervals by this much; the
/// refit's margin covers it.
inline constexpr double kWeightTolerance = 1e-9;

/// Appends the corners r_1 ... r_m, n numbers each, to `corners`. Precondition: W', widened by
/// kWeightTolerance, is not empty (as it is when the intervals come from weights that sum to 1).
/// At least one corner, at most 2, 6, 12 for n = 2, 3, 4 and 280 for n = 8.
void append_weight_corners(std::span<const WeightInterval> intervals, std::vector<double>& corners);

}  // namespace pelt::paper
