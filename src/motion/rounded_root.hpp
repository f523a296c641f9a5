#pragma once

#include "base/bits.hpp"
#include "exact/critical_time.hpp"
#include "motion/moving_features.hpp"
#include "motion/moving_pieces.hpp"
#include "motion/moving_polynomials.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pelt::detail {
namespace moving {

/// The corners of a determinant, in its order.
inline std::array<std::size_t, 4> corners_of(const FeaturePair& features) {
  const std::size_t i = features.i, j = features.j;
  if (features.kind == FeaturePair::Kind::face_and_corner) return {0, 1, 2, 3 + j};
  if (features.kind == FeaturePair::Kind::corner_and_face) return {3, 4, 5, i};
  return {i, (i + 1) % 3, 3 + j, 3 + (j + 1) % 3};
}

/// The sign of a determinant at floats, on a piece in which it has one root.
class SignAtFloat {
 public:
  SignAtFloat(const MovingTriangle& a, const MovingTriangle& b, const Piece& piece,
              unsigned determinant, double error)
      : a_(a), b_(b), piece_(piece), determinant_(determinant), error_(error) {}

  int operator()(float time) {
    const double value = value_at(time);
    if (value > error_) return 1;
    return value < -error_ ? -1 : exact_sign(time);
  }

 private:
  double value_at(double time) const {
    const double per_time = 1 / (piece_.end - piece_.start);
    const double part = (time - piece_.start) * per_time, rest = (piece_.end - time) * per_time;
    const auto coefficient = [&](std::size_t k) { return piece_.cubics[k][determinant_]; };
    return rest * rest * (rest * coefficient(0) + 3 * part * coefficient(1)) +
           part * part * (3 * rest * coefficient(2) + part * coefficient(3));
  }

  int exact_sign(float time) {
    if (!exact_)
      exact_ = orient3d_polynomial(moving_points(a_, b_), corners_of(FeaturePair(determinant_)));
    return sign_at(*exact_, dyadic(double{time}));
  }

  const MovingTriangle &a_, &b_;
  const Piece& piece_;
  unsigned determinant_;
  double error_;
  std::optional<Cubic> exact_;
};

/// The largest float that is not above the root. `guess`: a time near it. Precondition: the ends of
/// the piece are floats, and the sign is certain there.
inline float rounded_down(const Piece& piece, double guess, SignAtFloat& sign) {
  const auto bits = [](double time) { return bits_as<std::uint32_t>(static_cast<float>(time)); };
  std::uint32_t low = bits(piece.start), high = bits(piece.end);
  std::uint32_t middle = std::clamp(bits(guess), low + 1, high - 1);
  const int sign_after = sign(static_cast<float>(piece.end));
  for (bool is_near = true; high - low > 1; is_near = false) {
    const bool is_after = sign(bits_as<float>(middle)) == sign_after;
    (is_after ? high : low) = middle;
    middle = !is_near ? low + (high - low) / 2 : is_after ? high - 1 : low + 1;
  }
  return bits_as<float>(low);
}

}  // namespace moving
}  // namespace pelt::detail
