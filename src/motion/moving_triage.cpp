/// Tests eight pairs of moving triangles at once in float32. Decides a pair only if rounding cannot
/// have changed a sign.
///
/// The determinants of `moving_determinants.hpp` are cubics in time. On [0, 1], a cubic lies
/// between its least and its greatest coefficient in the basis of Bernstein.
///
/// Apart. At all times, one of two things separates the triangles:
/// - The plane of one of them, if all three corners of the other are on one side, with all twelve
///   coefficients.
/// - The planes that edge i of a, from p, and edge j of b, from q, span.
/// Let n be the cross product of the two edges' vectors, and let f, g and h be the heights along n
/// of q over p, of a's third corner over p, and of b's third corner over q. All of b is above all
/// of a along n if f + min(0, h) - max(0, g) > 0, and below if f + max(0, h) - min(0, g) < 0. Such
/// a function is bounded by what the same formula makes of coefficients. Furthermore,
///   f = -orient3d of the edges,  g = -rise of b's edge over a's plane,  h = rise of a's edge over
///   b's plane,
/// because n times an edge of a is a determinant with two edges of a, whose product is a's normal.
///
/// Intersecting. At times 1/2, 1/4 and 3/4, or in the middle of a piece, the test of
/// `triangle_triage.cpp` finds that they do.
///
/// Pieces. A pair that is neither is tested in eight pieces of its time at once, one in each lane,
/// and again in eight pieces of the time from the first to the last undecided piece
/// (`EightPieces`). The coefficients on a piece are means of those on [0, 1]. A pair is apart if
/// it is apart in all pieces.
///
/// Rounding. Let e = 2^-24, A the largest computed absolute component of u and v at both ends, B
/// that of r and s, W that of w, and D the largest of the three. A coefficient of a determinant is
/// the mean of at most three determinants, each a sum of six products. The largest number of
/// relative errors e of a product:
///
///   9   two components and their product; a component is a mean of rounded differences, with the
///       errors of a difference, of 1 - t, of a product and of a sum
///   11  the difference of a cross product, the sum of two cross products
///   18  a component, a product, two sums of a dot product
///   19  the sum of two dot products
///   21  the rounded third, the product with it
///
/// If products are below V, the error of a coefficient is therefore below 6 * 21.1 e V < 127 e V,
/// and its value below 6.1 V. A determinant at one time, or a coefficient on a piece, is the sum of
/// four coefficients times exact weights that sum to 1, with at most four more relative errors:
/// below 127 e V + 4 * 6.1 e V < 152 e V. Sums of two or three determinants are below 13 V and 19
/// V, so that they add 13 e V and 19 e V.
///
///   value                                  V      error                          bound
///   height over a, two determinants        A A D  (2 * 152 + 13) e V = 317       512 e V
///   height over b, two determinants        B B D  the same
///   rise, two determinants                 A B D  317
///   edges[0] or [2], three determinants    A B D  (3 * 152 + 32) e V = 488
///   edges[1]: a rise and two of these,     A B D  317 + 2 * 488
///     partial sums below 31 V and 49 V             + 80 = 1373                   1536 e V
///   separator: edges and two rises,        A B D  1373 + 2 * 317
///     partial sums below 61 V and 74 V             + 135 = 2142                  2304 e V
///
/// The bounds also cover the rounding of V and of themselves.
///   Underflow: sums do not underflow. A product that interpolates a component may lose 2^-150. The
/// code adds 2^-100 to A and B, so this is less than 2^-49 relative to them, which the bounds
/// cover. A product in a cross product has an additional error of at most 2^-150, which is
/// multiplied by a difference below 2^61.1; a coefficient is a mean of at most 18 of these, a
/// separator has 12 coefficients: less than 2^-80, which the code adds to the bounds. Later
/// products add less than 2^-140.
///   Overflow: sums of two cross products are below 2^125. No value exceeds 80 V, and bounds are
/// computed from 128 V. If that overflows, the bound is infinite or NaN, no comparison with it
/// holds, and the lane remains undecided.
#include "motion/moving_triage.hpp"

#include "motion/moving_filter.hpp"
#include "motion/moving_signs.hpp"

#include <bit>
#include <cstddef>
#include <initializer_list>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests one pair of moving triangles in eight pieces of its time at once, one in each lane.
///
///     times    0                                       1
///     first    |    |    |    | ?  | ?  |    |    |    |   ?: undecided pieces
///     then                    |_|_|_|_|_|_|_|_|            from the first to the last of these
class EightPieces {
 public:
  /// The pair in one lane of determinants on [0, 1].
  EightPieces(const Cubics8& cubics, const MovingCertainties& certainly, unsigned lane)
      : certainly_(certainly.of_lane(lane)) {
    for (const auto cubic :
         {&Cubics8::uvw, &Cubics8::uvr, &Cubics8::uvs, &Cubics8::rsw, &Cubics8::rsu, &Cubics8::rsv,
          &Cubics8::uwr, &Cubics8::uws, &Cubics8::vwr, &Cubics8::vws})
      for (std::size_t k = 0; k < 4; ++k)
        (cubics_.*cubic)[k] = Float8(lane_of((cubics.*cubic)[k], lane));
  }

  /// Decides, if this is certain, whether the triangles intersect.
  CertainAnswer test() {
    for (int round = 0; round < kRounds; ++round) {
      const CertainAnswer answer = test_pieces();
      if (answer != CertainAnswer::unknown) return answer;
    }
    return CertainAnswer::unknown;
  }

 private:
  /// With more, times would not be multiples of 1/128 (BernsteinWeights).
  static constexpr int kRounds = 2;

  CertainAnswer test_pieces() {
    const float step = (end_ - start_) / 8;
    alignas(32) float starts[8];
    for (int k = 0; k < 8; ++k) starts[k] = start_ + static_cast<float>(k) * step;
    const Float8 start = load8(starts), end = start + Float8(step);
    const BernsteinWeights weights[] = {
        BernsteinWeights(start), {start, start, end}, {start, end, end}, BernsteinWeights(end)};
    const unsigned left = kAllLanes & ~CertainlyApart([&](std::size_t k) {
                                         return each_of(cubics_, weights[k]);
                                       }).lanes(certainly_);
    if (left == 0) return CertainAnswer::no;
    const BernsteinWeights middle(start + Float8(step / 2));
    if (certainly_intersecting(Orientations8(each_of(cubics_, middle)), certainly_) != 0)
      return CertainAnswer::yes;
    start_ = starts[std::countr_zero(left)];
    end_ = starts[std::bit_width(left) - 1] + step;
    return CertainAnswer::unknown;
  }

  Cubics8 cubics_;
  MovingCertainties certainly_;
  float start_ = 0, end_ = 1;  ///< outside of these times, the triangles are certainly apart
};

/// The coordinates of three corners on one axis.
struct Range8 {
  Float8 low, high;

  Range8(const Points8 (&corners)[3], Float8 Points8::*axis)
      : low(lowest({corners[0].*axis, corners[1].*axis, corners[2].*axis})),
        high(highest({corners[0].*axis, corners[1].*axis, corners[2].*axis})) {}
};

/// Removes the times at which a gap is positive. The gap is linear in time.
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

/// Looks for times at which the pairs in `asked` that are not decided yet intersect.
void find_intersecting(const Cubics8& cubics, const MovingCertainties& certainly, unsigned asked,
                       Triage& result) {
  for (const int k : {4, 2, 6}) {
    const unsigned undecided = asked & ~result.intersecting;
    if (undecided == 0) break;
    const BernsteinWeights at(Float8(static_cast<float>(k) / 8));
    result.intersecting |=
        undecided & certainly_intersecting(Orientations8(each_of(cubics, at)), certainly);
  }
}

/// Tests the pairs in `asked` that are not decided yet in pieces.
void decide_in_pieces(const Cubics8& cubics, const MovingCertainties& certainly, unsigned asked,
                      Triage& result) {
  for (unsigned rest = asked & ~result.intersecting; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(rest));
    const CertainAnswer answer = EightPieces(cubics, certainly, lane).test();
    if (answer == CertainAnswer::no) result.apart |= 1u << lane;
    if (answer == CertainAnswer::yes) result.intersecting |= 1u << lane;
  }
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
  const MovingCertainties certainly = MovingCertainties::of(at_0, at_1);
  const Vectors8 from = between(times.start, at_0, at_1), to = between(times.end, at_0, at_1);
  Cubics8 cubics;
  compute_determinants(from, to, Float8(1.0f / 3), cubics);

  const CertainlyApart apart(
      [&](std::size_t k) { return each_of(cubics, [k](const Bernstein8& c) { return c[k]; }); });
  Triage result;
  result.apart = apart.lanes(certainly) | (times.end < times.start).bits();
  const unsigned left = asked & ~result.apart;
  find_intersecting(cubics, certainly, left, result);
  decide_in_pieces(cubics, certainly, left, result);
  return result;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
