#pragma once

/// Certain decisions about eight pairs of moving triangles, from determinants with bounded errors.
/// moving_triage.cpp derives the tests and the bounds.

#include "base/float8.hpp"
#include "geometry/points8.hpp"
#include "motion/moving_determinants.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

using Vectors8 = PairVectors<Points8>;
using Bernstein8 = BernsteinCubic<Float8>;
using Cubics8 = TenDeterminants<Bernstein8>;
using Orientations8 = PairOrientations<Float8>;

/// The signs that are certain.
struct MovingCertainties {
  Certainty over_a, over_b, edges, separators;

  static MovingCertainties of(const Vectors8& from, const Vectors8& to) {
    const Float8 tiny(0x1p-100f);
    const Float8 a = max(largest(from.u, to.u), largest(from.v, to.v)) + tiny;
    const Float8 b = max(largest(from.r, to.r), largest(from.s, to.s)) + tiny;
    const Float8 d = max(max(a, b), largest(from.w, to.w)) * Float8(128.0f);
    const auto bound = [&](const Float8& volume, float units) {
      return Certainty(volume * Float8(units * 0x1p-31f) + Float8(0x1p-80f));
    };
    return {bound(a * a * d, 512), bound(b * b * d, 512), bound(a * b * d, 1536),
            bound(a * b * d, 2304)};
  }

  /// Returns the bounds of one lane, in all lanes.
  MovingCertainties of_lane(unsigned lane) const {
    return {over_a.of_lane(lane), over_b.of_lane(lane), edges.of_lane(lane),
            separators.of_lane(lane)};
  }

 private:
  static Float8 largest(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }

  static Float8 largest(const Points8& p, const Points8& q) { return max(largest(p), largest(q)); }
};

/// Applies a function of a cubic to all determinants.
template <typename Function>
TenDeterminants<Float8> each_of(const Cubics8& d, const Function& of) {
  return {of(d.uvw), of(d.uvr), of(d.uvs), of(d.rsw), of(d.rsu),
          of(d.rsv), of(d.uwr), of(d.uws), of(d.vwr), of(d.vws)};
}

/// Decides from the coefficients, in the basis of Bernstein, which pairs are certainly apart at all
/// times.
class CertainlyApart {
 public:
  /// `coefficient(k)`: the determinants' coefficient k.
  template <typename Coefficient>
  explicit CertainlyApart(const Coefficient& coefficient)
      : values_{Orientations8(coefficient(0)), Orientations8(coefficient(1)),
                Orientations8(coefficient(2)), Orientations8(coefficient(3))} {}

  unsigned lanes(const MovingCertainties& certainly) const {
    return (aside(&Orientations8::over_a, certainly.over_a) |
            aside(&Orientations8::over_b, certainly.over_b) | parted_by_edges(certainly.separators))
        .bits();
  }

 private:
  /// Lanes in which all corners are on one side of a plane.
  Mask8 aside(Three Orientations8::*heights, const Certainty& certainly) const {
    Float8 low = lowest(values_[0].*heights), high = highest(values_[0].*heights);
    for (std::size_t k = 1; k < 4; ++k) {
      low = min(low, lowest(values_[k].*heights));
      high = max(high, highest(values_[k].*heights));
    }
    return certainly.positive(low) | certainly.negative(high);
  }

  /// Lanes in which the planes that two edges span separate the triangles.
  Mask8 parted_by_edges(const Certainty& certainly) const {
    Float8 front(-HUGE_VALF), back(HUGE_VALF);
    const Float8 zero(0.0f);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        Float8 low(HUGE_VALF), high(-HUGE_VALF);
        for (const Orientations8& v : values_) {
          const Float8 &edges = v.edges[i][j], &a = v.rise_a[i], &b = v.rise_b[j];
          low = min(low, edges - max(a, zero) - max(b, zero));
          high = max(high, edges - min(a, zero) - min(b, zero));
        }
        front = max(front, low);
        back = min(back, high);
      }
    return certainly.positive(front) | certainly.negative(back);
  }

  std::array<Orientations8, 4> values_;
};

/// Lanes in which the triangles certainly intersect at one time, as in `triage`.
inline unsigned certainly_intersecting(const Orientations8& values,
                                       const MovingCertainties& certainly) {
  const Three &over_a = values.over_a, &over_b = values.over_b;
  const Mask8 all_known =
      certainly.over_a.all_some_sign(over_a) & certainly.over_b.all_some_sign(over_b);
  const Mask8 aside = certainly.over_a.all_one_sign(over_a) | certainly.over_b.all_one_sign(over_b);
  const unsigned crossing = all_known.bits() & ~aside.bits();
  if (crossing == 0) return 0;

  const auto order = [&](const Edge& edge_a, const Edge& edge_b) {
    return edge_a.of(
        {edge_b.of(values.edges[0]), edge_b.of(values.edges[1]), edge_b.of(values.edges[2])});
  };
  const Float8 down = order(certainly.over_b.edge_down(over_b), certainly.over_a.edge_down(over_a));
  const Float8 up = order(certainly.over_b.edge_up(over_b), certainly.over_a.edge_up(over_a));
  return crossing & (certainly.edges.negative(down) & certainly.edges.positive(up)).bits();
}

// Values of cubics in the basis of Bernstein, and their coefficients on pieces of [0, 1].
//
// The polar form (blossom) of a cubic with the coefficients c0 to c3 is symmetric, affine in each
// of its three arguments, and equals the cubic if all three are equal:
//
//     b(x, y, z) = (1-x)(1-y)(1-z) c0 + (x(1-y)(1-z) + ...) c1 + (xy(1-z) + ...) c2 + xyz c3
//
// The coefficients on [s, e] are b(s, s, s), b(s, s, e), b(s, e, e) and b(e, e, e) (Ramshaw 1987).
// On a piece of [0, 1], the weights of c0 to c3 are not negative and sum to 1.

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
