/// Decides about a pair of moving triangles in double. Starts with the piece of the step in which
/// the boxes of the triangles overlap, with ends rounded to multiples of 2^-10, and halves pieces
/// where necessary. The ends of all pieces are therefore floats.

#include "motion/moving_filter.hpp"

#include "base/bits.hpp"
#include "exact/critical_time.hpp"
#include "motion/moving_pieces.hpp"
#include "motion/moving_polynomials.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pelt::detail {

namespace moving {
namespace {

// Searches a piece of the step for the first time at which two triangles intersect that are
// disjoint at time 0.
//
// This time is a root of a determinant whose features intersect then (`moving_pair.cpp`). Almost
// always, each determinant that is not constant in sign has one sign change in its coefficients
// on the piece, and therefore one root. The roots are approximated and enclosed between times at
// which the signs are certain. Where enclosures are disjoint, the order of roots is certain, and
// with it the sign of each determinant at the roots of the others: before its own root, a
// determinant has its sign at the start of the piece, and after it, its sign at the end. These
// signs decide whether the features of a root intersect.
//
// The first root at which they do is the first time if each other root is certainly later or has
// disjoint features. No other features intersect then, so these are also the first ones in the
// order of `FirstMeeting`: the corner is inside the face, and the edges cross between their ends.

/// Half the width of an enclosure, as a part of the piece.
inline constexpr double kHalfWidth = 0x1p-24;

/// Parts of the piece at which the cubics are zero, by three steps of Newton's method. If it
/// does not converge, the root is not enclosed.
inline Fifteen approximate_roots(const Cubics& p) {
  const Fifteen c = 3 * (p[1] - p[0]), b = 3 * (p[0] - p[1] + (p[2] - p[1]));
  const Fifteen a = p[3] - p[0] + 3 * (p[1] - p[2]);
  const Fifteen two_b = 2 * b, three_a = 3 * a;
  Fifteen x = p[0] / (p[0] - p[3]);
  for (int step = 0; step < 3; ++step) {
    const Fifteen value = ((a * x + b) * x + c) * x + p[0];
    const Fifteen slope = (three_a * x + two_b) * x + c;
    x = x - value / slope;
  }
  return min(max(x, Fifteen(kHalfWidth)), Fifteen(1 - kHalfWidth));
}

/// A root of a determinant in a piece, near a part of it from 0 to 1.
struct Root {
  unsigned determinant = 0;
  double part = 0;
};

class PieceSearch {
 public:
  PieceSearch(const Cubics& cubics, const Fifteen& errors)
      : first_(cubics[0], errors), last_(cubics[3], errors) {
    const Signs second(cubics[1], errors), third(cubics[2], errors);
    constant_ = first_ & second & third & last_;
    left_ = kAll & ~(constant_.positive | constant_.negative | Meetings(constant_).never);
    parts_ = approximate_roots(cubics);
    starts_ = parts_ - Fifteen(kHalfWidth);
    ends_ = parts_ + Fifteen(kHalfWidth);
    const unsigned with_one_root =
        equal(first_, -last_) & (equal(first_, second) | equal(third, last_));
    enclosed_ = with_one_root & equal(first_, Signs(values_at(starts_, cubics), errors)) &
                equal(last_, Signs(values_at(ends_, cubics), errors));
  }

  /// Whether the features of some root intersect then. If so, sets `root`.
  CertainAnswer find(Root& root) {
    if ((left_ & ~enclosed_) != 0) return CertainAnswer::unknown;
    while (left_ != 0) {
      root = take_root();
      const CertainAnswer answer = meet(root);
      if (answer != CertainAnswer::no) return answer;
    }
    return CertainAnswer::no;
  }

  /// The same, for the first such root. Returns unknown if another one may be earlier or equal.
  CertainAnswer find_first(Root& root) {
    const CertainAnswer answer = find(root);
    if (answer != CertainAnswer::yes) return answer;
    left_ &= ~later_than(root);
    Root other;
    return find(other) == CertainAnswer::no ? CertainAnswer::yes : CertainAnswer::unknown;
  }

 private:
  static constexpr unsigned kAll = (1u << kDeterminants) - 1;

  /// Removes the root that seems to be the first one.
  Root take_root() {
    Root root = {0, 2};
    for (unsigned rest = left_; rest != 0; rest &= rest - 1) {
      const auto determinant = static_cast<unsigned>(std::countr_zero(rest));
      const double part = parts_[determinant];
      if (part < root.part) root = {determinant, part};
    }
    left_ &= ~(1u << root.determinant);
    return root;
  }

  /// Whether the features intersect at a root.
  CertainAnswer meet(const Root& root) const {
    const Meetings meetings(signs_at(root));
    const unsigned bit = 1u << root.determinant;
    if ((meetings.never & bit) != 0) return CertainAnswer::no;
    return (meetings.always & bit) != 0 ? CertainAnswer::yes : CertainAnswer::unknown;
  }

  /// The signs of the other determinants at a root.
  Signs signs_at(const Root& root) const {
    const unsigned before = later_than(root), after = earlier_than(root);
    return {constant_.positive | (first_.positive & before) | (last_.positive & after),
            constant_.negative | (first_.negative & before) | (last_.negative & after)};
  }

  /// The determinants whose roots are certainly later, or certainly earlier.
  unsigned later_than(const Root& root) const {
    return enclosed_ & less(Fifteen(root.part + kHalfWidth), starts_);
  }
  unsigned earlier_than(const Root& root) const {
    return enclosed_ & less(ends_, Fifteen(root.part - kHalfWidth));
  }

  Signs first_, last_;       ///< at the start and at the end of the piece
  Signs constant_ = {0, 0};  ///< throughout the piece
  unsigned left_;            ///< determinants whose roots are not yet looked at
  unsigned enclosed_ = 0;    ///< those with one root, between a start and an end
  Fifteen parts_, starts_, ends_;
};

// The step of a pair.

/// Times outside which the boxes of the triangles are disjoint: multiples of 2^-10.
class TimeSpanOfBoxes {
 public:
  TimeSpanOfBoxes(const MovingTriangle& a, const MovingTriangle& b) {
    cut(a, b, &Vec3::x);
    cut(a, b, &Vec3::y);
    cut(a, b, &Vec3::z);
    if (end_ < start_) return;
    start_ = std::min(std::floor(start_ * 0x1p10), 1023.0) * 0x1p-10;
    end_ = std::max(std::ceil(end_ * 0x1p10) * 0x1p-10, start_ + 0x1p-10);
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

/// The corners of a determinant, in its order.
std::array<std::size_t, 4> corners_of(const FeaturePair& features) {
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
float rounded_down(const Piece& piece, double guess, SignAtFloat& sign) {
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

Vectors vectors(const TriangleCorners& a, const TriangleCorners& b) {
  const Vec3d of_a[3] = {Vec3d(a[0]), Vec3d(a[1]), Vec3d(a[2])};
  const Vec3d of_b[3] = {Vec3d(b[0]), Vec3d(b[1]), Vec3d(b[2])};
  return {of_a, of_b};
}

/// The bisection of one pair's step.
class Bisection {
 public:
  Bisection(const MovingTriangle& a, const MovingTriangle& b) : a_(a), b_(b) {
    const TimeSpanOfBoxes times(a, b);
    if (times.is_empty()) return;
    const Vectors from = vectors(a.from, b.from), to = vectors(a.to, b.to);
    errors_ = error_bounds(from, to);
    Piece& piece = pieces_[count_++];
    piece.start = times.start();
    piece.end = times.end();
    piece.cubics = fifteen_cubics(between(times.start(), from, to), between(times.end(), from, to));
  }

  bool intersect_at_start() const {
    return count_ > 0 && last().start == 0 && triangles_intersect(a_.from, b_.from);
  }

  /// Whether the triangles intersect. Precondition: they are disjoint at time 0.
  CertainAnswer intersect() {
    Root root;
    bool is_certain = true;
    while (count_ > 0) {
      const CertainAnswer answer = PieceSearch(last().cubics, errors_).find(root);
      if (answer == CertainAnswer::yes) return answer;
      if (answer == CertainAnswer::unknown && split()) continue;
      is_certain = is_certain && answer == CertainAnswer::no;
      --count_;
    }
    return is_certain ? CertainAnswer::no : CertainAnswer::unknown;
  }

  /// The same. If they intersect, sets `meeting`.
  CertainAnswer find_first(FirstMeeting& meeting) {
    Root root;
    while (count_ > 0) {
      const CertainAnswer answer = PieceSearch(last().cubics, errors_).find_first(root);
      if (answer == CertainAnswer::yes) set(meeting, root);
      if (answer == CertainAnswer::yes) return answer;
      if (answer == CertainAnswer::no) --count_;
      if (answer == CertainAnswer::unknown && !split()) return answer;
    }
    return CertainAnswer::no;
  }

 private:
  static constexpr int kMostSplits = 40;

  const Piece& last() const { return pieces_[count_ - 1]; }

  /// Replaces the last piece by its halves, the first half last. Returns false if that has been
  /// done too often.
  bool split() {
    if (last().depth == kMostHalvings || splits_ == kMostSplits) return false;
    ++splits_;
    pieces_[count_] = last();
    halve(pieces_[count_], pieces_[count_ - 1]);
    ++count_;
    return true;
  }

  void set(FirstMeeting& meeting, const Root& root) const {
    const Piece& piece = last();
    SignAtFloat sign(a_, b_, piece, root.determinant, errors_[root.determinant]);
    meeting.time = rounded_down(piece, piece.start + root.part * (piece.end - piece.start), sign);
    const FeaturePair features(root.determinant);
    using Kind = FeatureKind;
    switch (features.kind) {
      case FeaturePair::Kind::face_and_corner:
        meeting.a = {Kind::face, 0}, meeting.b = {Kind::corner, features.j};
        break;
      case FeaturePair::Kind::corner_and_face:
        meeting.a = {Kind::corner, features.i}, meeting.b = {Kind::face, 0};
        break;
      case FeaturePair::Kind::edges:
        meeting.a = {Kind::edge, features.i}, meeting.b = {Kind::edge, features.j};
        break;
    }
  }

  const MovingTriangle &a_, &b_;
  Fifteen errors_;
  std::array<Piece, kMostHalvings + 1> pieces_;
  std::size_t count_ = 0;
  int splits_ = 0;
};

}  // namespace
}  // namespace moving

CertainAnswer certainly_intersect(const MovingTriangle& a, const MovingTriangle& b) {
  moving::Bisection bisection(a, b);
  return bisection.intersect_at_start() ? CertainAnswer::yes : bisection.intersect();
}

bool find_certain_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                std::optional<FirstMeeting>& meeting) {
  moving::Bisection bisection(a, b);
  meeting.emplace();
  meeting->at_start = bisection.intersect_at_start();
  if (meeting->at_start) return true;
  const CertainAnswer answer = bisection.find_first(*meeting);
  if (answer != CertainAnswer::yes) meeting.reset();
  return answer != CertainAnswer::unknown;
}

bool intersect_while_moving(const MovingTriangle& a, const MovingTriangle& b, MovingStats& work) {
  ++work.double_pairs;
  const CertainAnswer answer = certainly_intersect(a, b);
  if (answer != CertainAnswer::unknown) return answer == CertainAnswer::yes;
  ++work.exact_pairs;
  return first_meeting(a, b).has_value();
}

std::optional<FirstMeeting> find_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                               MovingStats& work) {
  ++work.double_pairs;
  std::optional<FirstMeeting> first;
  if (find_certain_first_meeting(a, b, first)) return first;
  ++work.exact_pairs;
  return first_meeting(a, b);
}

MovingContact moving_contact(const Contact& contact, const FirstMeeting& first) {
  if (first.at_start) return {contact, 0, true, {}, {}};
  return {contact, first.time, false, first.a, first.b};
}

}  // namespace pelt::detail
