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
#include "geometry/moving_filter.hpp"

#include "geometry/box_times.hpp"
#include "geometry/moving_pieces.hpp"
#include "geometry/rounded_root.hpp"

#include <array>
#include <cstddef>

namespace pelt::detail {
namespace moving {
namespace {

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
}  // namespace moving

CertainAnswer certainly_intersect(const MovingTriangle& a, const MovingTriangle& b) {
  return moving::Bisection(a, b).intersect();
}

bool find_certain_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                std::optional<FirstMeeting>& meeting) {
  return moving::Bisection(a, b).find_first(meeting);
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
