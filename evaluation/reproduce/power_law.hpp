#pragma once

#include <span>

namespace pelt::reproduce {

/// A point of a curve.
struct Measured {
  double size = 0, value = 0;
};

/// The b of the law value = a size^b that fits best, by least squares of the logarithms. Points
/// with a size or value of 0 have none and are left out. Precondition: others of two sizes remain.
double fitted_exponent(std::span<const Measured> points);

}  // namespace pelt::reproduce
