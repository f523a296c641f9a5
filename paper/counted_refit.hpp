#pragma once

/// The refit of section 4.2 of Kavan & Zara 2005, written a second time, step by step, with numbers
/// that count their operations, for comparison with the total in the paper,
///
///     sum_i (18 p_i + 11 m_i + 8 p_i m_i - 2).
///
/// One sphere encloses the corners of all k joint sets together, so the "- 2", of m - 1 comparisons
/// and as many selections, occurs once and not k times: a refit takes 2 (k - 1) flops more than the
/// formula.

#include "paper/refit.hpp"

#include <array>

namespace pelt::paper {

/// Floating point operations, by the steps of the refit.
struct RefitFlops {
  int transforms = 0;  ///< S_j = C_j S
  int blends = 0;      ///< R_a of eq. 5
  int enclosing = 0;   ///< the sphere around the R_a

  int total() const { return transforms + blends + enclosing; }
};

struct CountedRefit {
  std::array<double, 3> centre = {0, 0, 0};
  double radius = 0;  ///< without the margins that Refit adds
  RefitFlops flops;
};

/// Precondition: no joint of the palette stretches.
CountedRefit counted_refit(const SphereModel& model, std::uint32_t node, const Palette& palette);

/// The terms of the paper, summed over the joint sets.
RefitFlops stated_flops(std::span<const JointSet> sets);

}  // namespace pelt::paper
