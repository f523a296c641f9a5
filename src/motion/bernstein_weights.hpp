#pragma once

/// Values of cubics in the basis of Bernstein, and their coefficients on pieces of [0, 1].
///
/// The polar form (blossom) of a cubic with the coefficients c0 to c3 is symmetric, affine in each
/// of its three arguments, and equals the cubic if all three are equal:
///
///     b(x, y, z) = (1-x)(1-y)(1-z) c0 + (x(1-y)(1-z) + ...) c1 + (xy(1-z) + ...) c2 + xyz c3
///
/// The coefficients on [s, e] are b(s, s, s), b(s, s, e), b(s, e, e) and b(e, e, e) (Ramshaw 1987).
/// On a piece of [0, 1], the weights of c0 to c3 are not negative and sum to 1.

#include "base/float8.hpp"
#include "motion/moving_determinants.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The weights of the coefficients of a cubic in its polar form. Exact if the arguments are
/// multiples of 1/128 in [0, 1]: all intermediate values are then multiples of 2^-21 in [0, 1].
class BernsteinWeights {
 public:
  BernsteinWeights(const Float8& x, const Float8& y, const Float8& z) {
    const Float8 one(1.0f), not_x = one - x, not_y = one - y, not_z = one - z;
    weight_[0] = not_x * not_y * not_z;
    weight_[1] = (x * not_y + not_x * y) * not_z + not_x * not_y * z;
    weight_[2] = (x * not_y + not_x * y) * z + x * y * not_z;
    weight_[3] = x * y * z;
  }

  /// The weights of the value at one time.
  explicit BernsteinWeights(const Float8& time) : BernsteinWeights(time, time, time) {}

  Float8 operator()(const BernsteinCubic<Float8>& c) const {
    return weight_[0] * c[0] + weight_[1] * c[1] + (weight_[2] * c[2] + weight_[3] * c[3]);
  }

 private:
  Float8 weight_[4];
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
