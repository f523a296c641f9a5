#pragma once

/// Kavan & Zara 2005, section 4.1: the corners of the clipped weight simplex
///
///     W' = { w : l_i <= w_i <= h_i, w_1 + ... + w_n = 1 },
///
/// whose convex combinations are all of W'. They are constants of the model.

#include <span>
#include <vector>

namespace pelt::paper {

/// <l, h>: all weights that one joint has among a set of vertices.
struct WeightInterval {
  double low = 1, high = 0;

  void include(double weight) {
    if (weight < low) low = weight;
    if (weight > high) high = weight;
  }
};

/// Up to this many joints the corners are enumerated. A larger set would have thousands of corners
/// and gets the n corners l + (1 - sum l) e_a instead, whose hull contains W'.
inline constexpr std::size_t kMaxEnumeratedJoints = 8;

/// Rounding makes sums of weights differ from 1, so corners may leave their intervals by this much.
/// The margin of the refit covers it.
inline constexpr double kWeightTolerance = 1e-9;

/// Appends the corners r_1 ... r_m, n numbers each, to `corners`: at least one, at most 2, 6, 12
/// for n = 2, 3, 4 and 280 for n = 8. Precondition: W', widened by kWeightTolerance, is not empty
/// (as it is if the intervals come from weights that sum to 1).
void append_weight_corners(std::span<const WeightInterval> intervals, std::vector<double>& corners);

}  // namespace pelt::paper
