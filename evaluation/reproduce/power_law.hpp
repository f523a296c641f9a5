#pragma once

#include <span>

namespace pelt::reproduce {

/// A point of a curve.
struct Measured {
  double size = 0, value = 0;
};

/// The exponent b of the law value = a size^b that fits best (least squares of the logarithms).
/// Ignores points with a size or value of 0. Precondition: the other points have at least two
/// sizes.
double fitted_exponent(std::span<const Measured> points);

}  // namespace pelt::reproduce
