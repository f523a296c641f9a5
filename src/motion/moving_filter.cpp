/// Decides about a pair of moving triangles in double: about the part of the step in which the
/// boxes of the triangles are not disjoint. The ends of this part are multiples of 2^-10, and it is
/// halved where necessary, so that the ends of all pieces are floats.
#include "motion/moving_filter.hpp"

#include "base/bits.hpp"
#include "exact/critical_time.hpp"
#include "motion/moving_pieces.hpp"
#include "motion/moving_polynomials.hpp"
#include "motion/moving_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pelt::detail {
namespace moving {
namespace {

/// Times outside which the boxes of the triangles are disjoint: multiples of 2^-10.
class BoxTimes {
 public:
  BoxTimes(const MovingTriangle& a, const MovingTriangle& b) {
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
    const BoxTimes times(a, b);
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
    using Kind = ClosedFeature::Kind;
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
  const auto feature = [](const ClosedFeature& f) {
    return Feature{static_cast<FeatureKind>(f.kind), f.number};
  };
  if (first.at_start) return {contact, 0, true, {}, {}};
  return {contact, first.time, false, feature(first.a), feature(first.b)};
}

}  // namespace pelt::detail
