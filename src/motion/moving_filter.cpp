/// Decides about a pair of moving triangles in double: about the part of the step in which the
/// boxes of the triangles are not disjoint. The ends of this part are multiples of 2^-10, and it is
/// halved where necessary, so that the ends of all pieces are floats.
#include "motion/moving_filter.hpp"

#include "motion/box_times.hpp"
#include "motion/moving_pieces.hpp"
#include "motion/moving_search.hpp"
#include "motion/rounded_root.hpp"

#include <array>
#include <cstddef>

namespace pelt::detail {
namespace moving {
namespace {

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
