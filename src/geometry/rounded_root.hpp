#pragma once

#include "base/bits.hpp"
#include "geometry/critical_time.hpp"
#include "geometry/moving_pieces.hpp"
#include "geometry/moving_polynomials.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pelt::detail {
namespace moving {

/// The corners of a determinant, in its order.
inline std::array<std::size_t, 4> corners_of(const PieceSigns::Zero& zero) {
  const std::size_t i = zero.i, j = zero.j;
  if (zero.kind == PieceSigns::Zero::Kind::over_a) return {0, 1, 2, 3 + i};
  if (zero.kind == PieceSigns::Zero::Kind::over_b) return {3, 4, 5, i};
  return {i, (i + 1) % 3, 3 + j, 3 + (j + 1) % 3};
}

/// The float that a root of a determinant rounds down to.
class RoundedRoot {
 public:
  RoundedRoot(const MovingTriangle& a, const MovingTriangle& b, const Vectors& from,
              const Vectors& to, const Errors& errors, const PieceSigns::Zero& zero)
      : a_(a), b_(b), zero_(zero) {
    Cubics cubics;
    compute_determinants(from, to, 1.0 / 3, cubics);
    for (std::size_t k = 0; k < 4; ++k) cubic_[k] = zero.of(Orientations(coefficients(cubics, k)));
    error_ = zero.error(errors);
  }

  /// The largest float that is not above the root. Precondition: the determinant has one root in
  /// the piece, between its ends.
  float rounded_down(const Piece& piece) {
    auto low = bits_as<std::uint32_t>(static_cast<float>(piece.start));
    auto high = bits_as<std::uint32_t>(static_cast<float>(piece.end));
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      const auto time = bits_as<float>(middle);
      int sign = rounded_sign(time);
      if (sign == 0) sign = exact_sign(time);
      (sign == -zero_.sign_at_start ? high : low) = middle;
    }
    return bits_as<float>(low);
  }

 private:
  /// The sign by the algorithm of de Casteljau; 0 if it is not certain. Each of its three levels
  /// rounds four times, 1 - t included: together 12 * 49 u V for a sum of eight determinants below
  /// 49 V. The sum itself has an error below 741 u V as in `moving_triage.cpp`, but with 12
  /// relative errors a product, because nothing is restricted to a part of the step.
  int rounded_sign(double t) const {
    const double s = 1 - t;
    const double c01 = s * cubic_[0] + t * cubic_[1], c12 = s * cubic_[1] + t * cubic_[2];
    const double c23 = s * cubic_[2] + t * cubic_[3];
    return sign_of(s * (s * c01 + t * c12) + t * (s * c12 + t * c23), error_);
  }

  int exact_sign(float time) {
    if (!exact_) exact_ = orient3d_polynomial(moving_points(a_, b_), corners_of(zero_));
    return sign_at(*exact_, dyadic(double{time}));
  }

  const MovingTriangle &a_, &b_;
  const PieceSigns::Zero& zero_;
  Bernstein cubic_;
  double error_;
  std::optional<Cubic> exact_;
};

}  // namespace moving
}  // namespace pelt::detail
