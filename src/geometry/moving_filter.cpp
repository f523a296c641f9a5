/// Decides about a pair of moving triangles in double, by bisection of the step, or of the part of
/// it in which the boxes of the triangles are not disjoint (`moving_triage.cpp`). The ends of this
/// part are widened to multiples of 2^-10, so that the ends of all pieces are floats.
///
/// A piece of the step is left out if a plane of a triangle or of two edges separates the triangles
/// there, as in `moving_triage.cpp`, or if all signs are constant there and the triangles are
/// disjoint at an end: the first time of contact is a root of one of the fifteen determinants
/// (`moving_pair.cpp`), provided that these are not all zero. The first piece that is not left out
/// contains the first time of contact, if there is one. If exactly one determinant is zero there,
/// once, and the triangles are disjoint at its start and intersect at its end, then the first time
/// of contact is this root. The features that meet have their four corners in one plane, so they
/// are the corner and the face, or the edges, of this determinant.
///
/// Rounding, as in `moving_triage.cpp`, with u = 2^-53 instead of e: the error of a coefficient is
/// below 127 u V. To bisect, coefficients are replaced by means of neighbours, three times; a mean
/// rounds once, below 6.1 u V. At depth 12, the error is below (127 + 12 * 18.4) u V < 348 u V. In
/// units of u V, sums have errors below
///
///   height, two determinants                   2 * 348 + 13 = 709                      bound 1024
///   rise, two determinants                     709
///   edges[0] or [2], three determinants        3 * 348 + 32 = 1076
///   edges[1]: a rise and two of these          709 + 2 * 1076 + 80 = 2941              bound 3072
///   separator: edges and two rises             2941 + 2 * 709 + 135 = 4494             bound 5120
///
/// Nothing underflows or overflows: differences of floats are multiples of 2^-149 below 2^62.
#include "geometry/moving_filter.hpp"

#include "base/bits.hpp"
#include "base/vec3.hpp"
#include "geometry/moving_determinants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pelt::detail {
namespace {

constexpr int kMostBisections = 12;

using Vectors = PairVectors<Vec3d>;
using Bernstein = BernsteinCubic<double>;
using Cubics = TenDeterminants<Bernstein>;
using Orientations = PairOrientations<double>;

double largest(const Vec3d& p) {
  return std::max(std::max(std::abs(p.x), std::abs(p.y)), std::abs(p.z));
}

double largest(const Vec3d& p, const Vec3d& q) { return std::max(largest(p), largest(q)); }

/// 1 or -1 if the sign of a value with an error up to `error` is certain; otherwise 0.
int sign_of(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// The bounds in the head of this file.
struct Errors {
  double over_a, over_b, edges, separators;

  Errors(const Vectors& from, const Vectors& to) {
    const double a = std::max(largest(from.u, to.u), largest(from.v, to.v));
    const double b = std::max(largest(from.r, to.r), largest(from.s, to.s));
    const double d = std::max(std::max(a, b), largest(from.w, to.w)) * 0x1p-53;
    over_a = 1024 * a * a * d;
    over_b = 1024 * b * b * d;
    edges = 3072 * a * b * d;
    separators = 5120 * a * b * d;
  }
};

/// The vectors at one time.
Vec3d between(double time, const Vec3d& from, const Vec3d& to) {
  return (1 - time) * from + time * to;
}

Vectors between(double time, const Vectors& from, const Vectors& to) {
  Vectors result = from;
  result.u = between(time, from.u, to.u);
  result.v = between(time, from.v, to.v);
  result.r = between(time, from.r, to.r);
  result.s = between(time, from.s, to.s);
  result.w = between(time, from.w, to.w);
  return result;
}

/// Times outside which the boxes of the triangles are disjoint: multiples of 2^-10.
class BoxTimes {
 public:
  BoxTimes(const MovingTriangle& a, const MovingTriangle& b) {
    cut(a, b, &Vec3::x);
    cut(a, b, &Vec3::y);
    cut(a, b, &Vec3::z);
    start_ = std::floor(start_ * 0x1p10) * 0x1p-10;
    end_ = std::ceil(end_ * 0x1p10) * 0x1p-10;
  }

  bool is_empty() const { return end_ < start_; }
  double start() const { return start_; }
  double end() const { return end_; }

 private:
  struct Range {
    double low, high;

    Range(const TriangleCorners& t, float Vec3::*axis)
        : low(std::min({t[0].*axis, t[1].*axis, t[2].*axis})),
          high(std::max({t[0].*axis, t[1].*axis, t[2].*axis})) {}
  };

  void cut(const MovingTriangle& a, const MovingTriangle& b, float Vec3::*axis) {
    const Range a0(a.from, axis), a1(a.to, axis), b0(b.from, axis), b1(b.to, axis);
    cut(b0.low - a0.high, b1.low - a1.high);
    cut(a0.low - b0.high, a1.low - b1.high);
  }

  /// Leaves out the times at which there is a gap, given at times 0 and 1. The quotient has four
  /// relative errors 2^-53.
  void cut(double gap_at_0, double gap_at_1) {
    if (gap_at_0 > 0 && gap_at_1 > 0) end_ = -1;
    if ((gap_at_0 > 0) == (gap_at_1 > 0)) return;
    const double quotient = gap_at_0 / (gap_at_0 - gap_at_1);
    if (gap_at_0 > 0) start_ = std::max(start_, quotient * (1 - 0x1p-50));
    if (gap_at_1 > 0) end_ = std::min(end_, quotient * (1 + 0x1p-50));
  }

  double start_ = 0, end_ = 1;
};

TenDeterminants<double> coefficients(const Cubics& d, std::size_t k) {
  return {d.uvw[k], d.uvr[k], d.uvs[k], d.rsw[k], d.rsu[k],
          d.rsv[k], d.uwr[k], d.uws[k], d.vwr[k], d.vws[k]};
}

/// A part of the step.
struct Piece {
  double start = 0, end = 1;
  int depth = 0;
  Cubics cubics;
};

/// Replaces the coefficients by those for the first half, and sets those for the second one.
void halve(Bernstein& first, Bernstein& second) {
  const double c01 = (first[0] + first[1]) * 0.5, c12 = (first[1] + first[2]) * 0.5;
  const double c23 = (first[2] + first[3]) * 0.5;
  const double c012 = (c01 + c12) * 0.5, c123 = (c12 + c23) * 0.5;
  const double middle = (c012 + c123) * 0.5;
  second[0] = middle, second[1] = c123, second[2] = c23, second[3] = first[3];
  first[1] = c01, first[2] = c012, first[3] = middle;
}

/// Makes `first` the first half of the piece, and `second` the second half.
void halve(Piece& first, Piece& second) {
  second.end = first.end;
  second.start = first.end = (first.start + first.end) / 2;
  second.depth = ++first.depth;
  Cubics &p = first.cubics, &q = second.cubics;
  halve(p.uvw, q.uvw), halve(p.uvr, q.uvr), halve(p.uvs, q.uvs);
  halve(p.rsw, q.rsw), halve(p.rsu, q.rsu), halve(p.rsv, q.rsv);
  halve(p.uwr, q.uwr), halve(p.uws, q.uws), halve(p.vwr, q.vwr), halve(p.vws, q.vws);
}

using Heights = double[3];

bool all_beyond(const Heights& heights, int sign, double error) {
  return sign_of(heights[0], error) == sign && sign_of(heights[1], error) == sign &&
         sign_of(heights[2], error) == sign;
}

/// An edge from a corner on the side `sign` to a corner on the other side; 3 if there is none.
std::size_t edge_from(const Heights& heights, int sign, double error) {
  for (std::size_t i = 0; i < 3; ++i)
    if (sign_of(heights[i], error) == sign && sign_of(heights[(i + 1) % 3], error) == -sign)
      return i;
  return 3;
}

bool all_known(const Heights& heights, double error) {
  return std::all_of(heights, heights + 3, [&](double h) { return sign_of(h, error) != 0; });
}

/// Whether the triangles intersect at one time, as in `triage`.
CertainAnswer intersect_at(const Orientations& at, const Errors& errors) {
  for (const int sign : {1, -1})
    if (all_beyond(at.over_a, sign, errors.over_a) || all_beyond(at.over_b, sign, errors.over_b))
      return CertainAnswer::no;
  if (!all_known(at.over_a, errors.over_a) || !all_known(at.over_b, errors.over_b))
    return CertainAnswer::unknown;
  const auto order = [&](int sign) {
    const std::size_t of_a = edge_from(at.over_b, sign, errors.over_b);
    return sign_of(at.edges[of_a][edge_from(at.over_a, sign, errors.over_a)], errors.edges);
  };
  const int down = order(1), up = order(-1);
  if (down < 0 && up > 0) return CertainAnswer::yes;
  if (down > 0 || up < 0) return CertainAnswer::no;
  return CertainAnswer::unknown;
}

/// The four values of everything that has a sign, on one piece.
class PieceSigns {
 public:
  PieceSigns(const Piece& piece, const Errors& errors)
      : errors_(errors),
        at_{Orientations(coefficients(piece.cubics, 0)),
            Orientations(coefficients(piece.cubics, 1)),
            Orientations(coefficients(piece.cubics, 2)),
            Orientations(coefficients(piece.cubics, 3))} {}

  CertainAnswer at_start() const { return intersect_at(at_[0], errors_); }
  CertainAnswer at_end() const { return intersect_at(at_[3], errors_); }

  bool are_separated() const {
    for (const int sign : {1, -1})
      if (always([&](const Orientations& at) {
            return all_beyond(at.over_a, sign, errors_.over_a);
          }) ||
          always(
              [&](const Orientations& at) { return all_beyond(at.over_b, sign, errors_.over_b); }))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (edges_separate(i, j)) return true;
    return false;
  }

  /// The determinants that may be zero on the piece: which of fifteen, of which kind.
  struct Zero {
    std::size_t count = 0;
    bool is_once = false;  ///< there is one, and it has exactly one root
    int sign_at_start = 0;
    enum class Kind : std::uint8_t { over_a, over_b, edges } kind = Kind::edges;
    std::size_t i = 0, j = 0;  ///< the corner, or the edges

    double of(const Orientations& values) const {
      if (kind == Kind::over_a) return values.over_a[i];
      if (kind == Kind::over_b) return values.over_b[i];
      return values.edges[i][j];
    }

    double error(const Errors& errors) const {
      if (kind == Kind::over_a) return errors.over_a;
      return kind == Kind::over_b ? errors.over_b : errors.edges;
    }
  };

  Zero zero() const {
    Zero result;
    for (std::size_t i = 0; i < 3; ++i) {
      add(result, Zero::Kind::over_a, i, 0);
      add(result, Zero::Kind::over_b, i, 0);
      for (std::size_t j = 0; j < 3; ++j) add(result, Zero::Kind::edges, i, j);
    }
    return result;
  }

 private:
  template <typename Condition>
  bool always(const Condition& condition) const {
    return condition(at_[0]) && condition(at_[3]) && condition(at_[1]) && condition(at_[2]);
  }

  bool edges_separate(std::size_t i, std::size_t j) const {
    return always([&](const Orientations& at) {
             return at.edges[i][j] - std::max(at.rise_a[i], 0.0) - std::max(at.rise_b[j], 0.0) >
                    errors_.separators;
           }) ||
           always([&](const Orientations& at) {
             return at.edges[i][j] - std::min(at.rise_a[i], 0.0) - std::min(at.rise_b[j], 0.0) <
                    -errors_.separators;
           });
  }

  int sign(std::size_t k, Zero::Kind kind, std::size_t i, std::size_t j) const {
    if (kind == Zero::Kind::over_a) return sign_of(at_[k].over_a[i], errors_.over_a);
    if (kind == Zero::Kind::over_b) return sign_of(at_[k].over_b[i], errors_.over_b);
    return sign_of(at_[k].edges[i][j], errors_.edges);
  }

  /// Counts a determinant whose sign is not certainly constant. With different signs at the ends,
  /// it has exactly one sign change in its coefficients, and one root, if one of the others has
  /// certainly the sign of the end beside it.
  void add(Zero& zeros, Zero::Kind kind, std::size_t i, std::size_t j) const {
    const int s0 = sign(0, kind, i, j), s1 = sign(1, kind, i, j);
    const int s2 = sign(2, kind, i, j), s3 = sign(3, kind, i, j);
    if (s0 != 0 && s0 == s1 && s1 == s2 && s2 == s3) return;
    const bool is_once = s0 != 0 && s0 == -s3 && (s1 == s0 || s2 == s3);
    zeros = {zeros.count + 1, zeros.count == 0 && is_once, s0, kind, i, j};
  }

  const Errors& errors_;
  Orientations at_[4];
};

/// The corners of a determinant, in its order.
std::array<std::size_t, 4> corners_of(const PieceSigns::Zero& zero) {
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

/// The bisection of one pair's step.
class Bisection {
 public:
  Bisection(const MovingTriangle& a, const MovingTriangle& b)
      : a_(a),
        b_(b),
        from_(vectors(a.from, b.from)),
        to_(vectors(a.to, b.to)),
        errors_(from_, to_) {
    const BoxTimes times(a, b);
    if (times.is_empty()) return;
    Piece& piece = pieces_[count_++];
    piece.start = times.start();
    piece.end = times.end();
    compute_determinants(between(times.start(), from_, to_), between(times.end(), from_, to_),
                         1.0 / 3, piece.cubics);
  }

  CertainAnswer intersect() {
    bool is_certain = true;
    while (count_ > 0) {
      const PieceSigns signs(pieces_[count_ - 1], errors_);
      if (signs.at_start() == CertainAnswer::yes || signs.at_end() == CertainAnswer::yes)
        return CertainAnswer::yes;
      if (is_apart(signs, signs.zero())) {
        --count_;
      } else if (!split()) {
        is_certain = false;
        --count_;
      }
    }
    return is_certain ? CertainAnswer::no : CertainAnswer::unknown;
  }

  /// Returns false if the answer is not certain.
  bool find_first(std::optional<FirstMeeting>& meeting) {
    meeting.reset();
    while (count_ > 0) {
      const Piece& piece = pieces_[count_ - 1];
      const PieceSigns signs(piece, errors_);
      const PieceSigns::Zero zero = signs.zero();
      const CertainAnswer at_start = signs.at_start();
      if (at_start == CertainAnswer::yes && piece.start == 0) {
        meeting.emplace().at_start = true;
        return true;
      }
      if (zero.is_once && at_start == CertainAnswer::no && signs.at_end() == CertainAnswer::yes) {
        set(meeting.emplace(), piece, zero);
        return true;
      }
      if (is_apart(signs, zero)) {
        --count_;
      } else if (!split()) {
        return false;
      }
    }
    return true;
  }

 private:
  static constexpr int kMostPieces = 40;

  static Vectors vectors(const TriangleCorners& a, const TriangleCorners& b) {
    const Vec3d of_a[3] = {Vec3d(a[0]), Vec3d(a[1]), Vec3d(a[2])};
    const Vec3d of_b[3] = {Vec3d(b[0]), Vec3d(b[1]), Vec3d(b[2])};
    return {of_a, of_b};
  }

  static bool is_apart(const PieceSigns& signs, const PieceSigns::Zero& zero) {
    if (zero.count == 0 && signs.at_start() == CertainAnswer::no) return true;
    return signs.are_separated();
  }

  /// Replaces the last piece by its halves, the first half last. Returns false if that has been
  /// done too often.
  bool split() {
    if (pieces_[count_ - 1].depth == kMostBisections || bisections_ == kMostPieces) return false;
    ++bisections_;
    pieces_[count_] = pieces_[count_ - 1];
    halve(pieces_[count_], pieces_[count_ - 1]);
    ++count_;
    return true;
  }

  void set(FirstMeeting& meeting, const Piece& piece, const PieceSigns::Zero& zero) const {
    meeting.time = RoundedRoot(a_, b_, from_, to_, errors_, zero).rounded_down(piece);
    const auto i = static_cast<std::uint8_t>(zero.i), j = static_cast<std::uint8_t>(zero.j);
    using Kind = ClosedFeature::Kind;
    switch (zero.kind) {
      case PieceSigns::Zero::Kind::over_a:
        meeting.a = {Kind::face, 0}, meeting.b = {Kind::corner, i};
        break;
      case PieceSigns::Zero::Kind::over_b:
        meeting.a = {Kind::corner, i}, meeting.b = {Kind::face, 0};
        break;
      case PieceSigns::Zero::Kind::edges:
        meeting.a = {Kind::edge, i}, meeting.b = {Kind::edge, j};
        break;
    }
  }

  const MovingTriangle &a_, &b_;
  Vectors from_, to_;
  Errors errors_;
  std::array<Piece, kMostBisections + 1> pieces_;
  std::size_t count_ = 0;
  int bisections_ = 0;
};

}  // namespace

CertainAnswer certainly_intersect(const MovingTriangle& a, const MovingTriangle& b) {
  return Bisection(a, b).intersect();
}

bool find_certain_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                std::optional<FirstMeeting>& meeting) {
  return Bisection(a, b).find_first(meeting);
}

bool moving_triangles_intersect(const MovingTriangle& a, const MovingTriangle& b) {
  const CertainAnswer answer = certainly_intersect(a, b);
  if (answer != CertainAnswer::unknown) return answer == CertainAnswer::yes;
  return first_meeting(a, b).has_value();
}

std::optional<FirstMeeting> filtered_first_meeting(const MovingTriangle& a,
                                                   const MovingTriangle& b) {
  std::optional<FirstMeeting> meeting;
  if (find_certain_first_meeting(a, b, meeting)) return meeting;
  return first_meeting(a, b);
}

}  // namespace pelt::detail
