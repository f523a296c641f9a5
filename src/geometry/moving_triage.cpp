/// Tests eight pairs of moving triangles at once in float32. Decides a pair only if rounding cannot
/// have changed a sign.
///
/// The determinants of `moving_determinants.hpp` are cubics in time. On [0, 1], a cubic lies
/// between its least and its greatest coefficient in the basis of Bernstein.
///
/// Apart. At all times, one of two things separates the triangles:
///   The plane of one of them, if all three corners of the other are on one side, with all twelve
/// coefficients.
///   The planes that edge i of a, from p, and edge j of b, from r, span. Let n be the product of
///   the
/// two edges' vectors, and let f, g and h be the heights along n of r over p, of a's third corner
/// over p, and of b's third corner over r. All of b is above all of a along n if f + min(0, h) -
/// max(0, g) > 0, and below if f + max(0, h) - min(0, g) < 0. Such a function is bounded by what
/// the same formula makes of coefficients. Furthermore,
///   f = -orient3d of the edges,  g = -rise of b's edge over a's plane,  h = rise of a's edge over
///   b's plane,
/// because n times an edge of a is a determinant with two edges of a, whose product is a's normal.
///
/// Intersecting. At times k / 8, the test of `triangle_triage.cpp` finds that they do.
///
/// Rounding. Let e = 2^-24, A the largest computed absolute component of u and v at both ends, B
/// that of r and s, W that of w, and D the largest of the three. A coefficient of a determinant is
/// the mean of at most three determinants, each a sum of six products. The largest number of
/// relative errors e of a product:
///
///   3   two components, each a rounded difference, and their product
///   5   the difference of a cross product, the sum of two cross products
///   9   a rounded component, a product, two sums of a dot product
///   10  the sum of two dot products
///   12  the rounded third, the product with it
///
/// If products are below V, the error of a coefficient is therefore below 6 * 12.1 e V < 73 e V,
/// and its value below 6.1 V. A determinant at k / 8 is the sum of four coefficients times exact
/// weights that sum to 1, with four more relative errors: below 73 e V + 4 * 6.1 e V < 98 e V. Sums
/// of two or three determinants are below 13 V and 19 V, so that they add 13 e V and 19 e V.
///
///   value                                  V      error of a coefficient   at k / 8       bound
///   height over a, two determinants        A A D  (2 * 73 + 13) e V = 159  209 e V        256 e V
///   height over b, two determinants        B B D  the same
///   rise, two determinants                 A B D  159                      209
///   edges[0] or [2], three determinants    A B D  (3 * 73 + 32) e V = 251  326
///   edges[1]: a rise and two of these,     A B D  159 + 2 * 251            209 + 2 * 326
///     partial sums below 31 V and 49 V             + 80 = 741              + 80 = 941     1024 e V
///   separator: edges and two rises,        A B D  741 + 2 * 159
///     partial sums below 61 V and 74 V             + 135 = 1194                           2048 e V
///
/// The bounds also cover the rounding of V and of themselves.
///   Underflow: sums do not underflow. A product in a cross product has an additional error of at
/// most 2^-150, which is multiplied by a difference below 2^61.1; a coefficient is a mean of sums
/// of twelve of these, a separator has 12 coefficients: less than 2^-81. Later products add less
/// than 2^-140.
///   Overflow: sums of two cross products are below 2^125. No value exceeds 80 V, and bounds are
/// computed from 128 V. If that overflows, the bound is infinite or NaN, no comparison with it
/// holds, and the lane remains undecided.
#include "geometry/moving_triage.hpp"

#include "geometry/moving_determinants.hpp"
#include "geometry/triage_signs.hpp"

#include <cstddef>
#include <initializer_list>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

using Vectors8 = PairVectors<Points8>;
using Bernstein8 = BernsteinCubic<Float8>;
using Cubics8 = TenDeterminants<Bernstein8>;
using Orientations8 = PairOrientations<Float8>;

Float8 largest(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }

Float8 largest(const Points8& p, const Points8& q) { return max(largest(p), largest(q)); }

/// The bounds in the head of this file.
struct Certainties {
  Certainty over_a, over_b, edges, separators;

  static Certainties of(const Vectors8& from, const Vectors8& to) {
    const Float8 tiny(0x1p-100f);
    const Float8 a = max(largest(from.u, to.u), largest(from.v, to.v)) + tiny;
    const Float8 b = max(largest(from.r, to.r), largest(from.s, to.s)) + tiny;
    const Float8 d = max(max(a, b), largest(from.w, to.w)) * Float8(128.0f);
    const auto bound = [&](const Float8& volume, float units) {
      return Certainty(volume * Float8(units * 0x1p-31f) + Float8(0x1p-80f));
    };
    return {bound(a * a * d, 512), bound(b * b * d, 512), bound(a * b * d, 1536),
            bound(a * b * d, 2048)};
  }
};

/// Coefficient k of all determinants.
TenDeterminants<Float8> coefficients(const Cubics8& d, std::size_t k) {
  return {d.uvw[k], d.uvr[k], d.uvs[k], d.rsw[k], d.rsu[k],
          d.rsv[k], d.uwr[k], d.uws[k], d.vwr[k], d.vws[k]};
}

/// Lanes in which something is certain for all coefficients so far.
class Apart {
 public:
  /// Adds a coefficient of everything.
  void add(const Orientations8& values, const Certainties& certainly) {
    add_sides(over_a_, values.over_a, certainly.over_a);
    add_sides(over_b_, values.over_b, certainly.over_b);
    Three up_a, up_b, down_a, down_b;
    for (std::size_t i = 0; i < 3; ++i) {
      up_a[i] = max(values.rise_a[i], Float8(0.0f)),
      down_a[i] = min(values.rise_a[i], Float8(0.0f));
      up_b[i] = max(values.rise_b[i], Float8(0.0f)),
      down_b[i] = min(values.rise_b[i], Float8(0.0f));
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const Float8& value = values.edges[i][j];
        Sides& sides = edges_[i][j];
        sides.front = sides.front & certainly.separators.positive(value - up_a[i] - up_b[j]);
        sides.back = sides.back & certainly.separators.negative(value - down_a[i] - down_b[j]);
      }
  }

  Mask8 lanes() const {
    Mask8 result = over_a_.any() | over_b_.any();
    for (const auto& row : edges_)
      for (const Sides& sides : row) result = result | sides.any();
    return result;
  }

 private:
  struct Sides {
    Mask8 front = Float8(0.0f) <= Float8(0.0f), back = front;  // all lanes

    Mask8 any() const { return front | back; }
  };

  static void add_sides(Sides& sides, const Three& heights, const Certainty& certainly) {
    sides.front = sides.front & certainly.positive(lowest(heights));
    sides.back = sides.back & certainly.negative(highest(heights));
  }

  Sides over_a_, over_b_, edges_[3][3];
};

/// Weights of the coefficients of a cubic at time k / 8. All are exact.
struct Weights {
  Float8 weight[4];

  explicit Weights(int k) {
    const int rest = 8 - k;
    weight[0] = Float8(static_cast<float>(rest * rest * rest) * 0x1p-9f);
    weight[1] = Float8(static_cast<float>(3 * rest * rest * k) * 0x1p-9f);
    weight[2] = Float8(static_cast<float>(3 * rest * k * k) * 0x1p-9f);
    weight[3] = Float8(static_cast<float>(k * k * k) * 0x1p-9f);
  }

  Float8 operator()(const Bernstein8& c) const {
    return weight[0] * c[0] + weight[1] * c[1] + (weight[2] * c[2] + weight[3] * c[3]);
  }
};

TenDeterminants<Float8> values_at(const Weights& at, const Cubics8& d) {
  return {at(d.uvw), at(d.uvr), at(d.uvs), at(d.rsw), at(d.rsu),
          at(d.rsv), at(d.uwr), at(d.uws), at(d.vwr), at(d.vws)};
}

/// Lanes in which the triangles intersect at one time, as in `triage`.
unsigned intersecting(const Orientations8& values, const Certainties& certainly) {
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

/// The coordinates of three corners on one axis.
struct Range8 {
  Float8 low, high;

  Range8(const Points8 (&corners)[3], Float8 Points8::*axis)
      : low(lowest({corners[0].*axis, corners[1].*axis, corners[2].*axis})),
        high(highest({corners[0].*axis, corners[1].*axis, corners[2].*axis})) {}
};

/// Leaves out the times at which there is a gap, given at times 0 and 1.
void cut(TimeSpans8& times, const Float8& gap_at_0, const Float8& gap_at_1) {
  const Float8 zero(0.0f), quotient = gap_at_0 / (gap_at_0 - gap_at_1);
  const Float8 early = quotient * Float8(1 - 0x1p-21f) - Float8(0x1p-100f);
  const Float8 late = quotient * Float8(1 + 0x1p-21f) + Float8(0x1p-100f);
  const Mask8 at_0 = zero < gap_at_0, at_1 = zero < gap_at_1;
  const Mask8 closes = at_0 & (gap_at_1 <= zero), opens = (gap_at_0 <= zero) & at_1;
  times.start = select(closes, max(times.start, early), times.start);
  times.end = select(opens, min(times.end, late), times.end);
  times.end = select(at_0 & at_1, Float8(-1.0f), times.end);
}

}  // namespace

TimeSpans8 times_of_boxes(const MovingPairs8& pairs) {
  TimeSpans8 times = {Float8(0.0f), Float8(1.0f)};
  for (Float8 Points8::*axis : {&Points8::x, &Points8::y, &Points8::z}) {
    const Range8 a0(pairs.from.a, axis), b0(pairs.from.b, axis);
    const Range8 a1(pairs.to.a, axis), b1(pairs.to.b, axis);
    cut(times, b0.low - a0.high, b1.low - a1.high);
    cut(times, a0.low - b0.high, a1.low - b1.high);
  }
  return times;
}

Triage moving_triage(const MovingPairs8& pairs, const TimeSpans8& times, unsigned asked) {
  const Vectors8 at_0(pairs.from.a, pairs.from.b), at_1(pairs.to.a, pairs.to.b);
  const Certainties certainly = Certainties::of(at_0, at_1);
  const Vectors8 from = between(times.start, at_0, at_1), to = between(times.end, at_0, at_1);
  Cubics8 cubics;
  compute_determinants(from, to, Float8(1.0f / 3), cubics);

  Apart apart;
  for (std::size_t k = 0; k < 4; ++k) apart.add(Orientations8(coefficients(cubics, k)), certainly);
  Triage result;
  result.apart = (apart.lanes() | (times.end < times.start)).bits();
  for (const int k : {4, 2, 6, 1, 3, 5, 7, 0, 8}) {
    const unsigned undecided = asked & ~result.apart & ~result.intersecting;
    if (undecided == 0) break;
    const Orientations8 values(values_at(Weights(k), cubics));
    result.intersecting |= undecided & intersecting(values, certainly);
  }
  return result;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
