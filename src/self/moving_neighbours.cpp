/// Whether two triangles of a surface intersect is a function of the signs that `moving_pair.cpp`
/// names, also with shared corners: each rule asks whether the hulls of some of the six corners
/// intersect, whether two corners coincide, or on which sides of an edge two corners lie in a
/// plane. Let no critical polynomial vanish on an open interval: no chi that is not identically
/// zero; if all are, no psi; if these are, too, no lam. Then the answer is constant on the
/// interval:
///   Hulls of any of the corners. A circuit of them extends to points that span the space, the
/// plane or the line of all six, as in the proof there.
///   Coincidence. If two corners are apart at some time of the interval, they extend to points that
/// span, and the critical polynomial of these is zero where the corners coincide.
///   Sides of an edge. This rule is asked about four distinct points in one plane; the polynomials
/// are chi of these points, and psi or lam if all six corners are coplanar at all times.
/// The answer is therefore asked at time 0, at the critical times, immediately after each of these,
/// and at time 1. Unlike closed triangles without shared corners, neighbours may intersect after a
/// critical time and not at it.
#include "self/moving_neighbours.hpp"

#include "motion/instants.hpp"
#include "self/neighbour_by_signs.hpp"

#include <algorithm>

namespace pelt::detail {

static bool coincide(const InstantCorner& p, const InstantCorner& q) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (compare(p, q, axis) != 0) return false;
  return true;
}

/// Nothing is quick here.
static bool is_aside(const DistinctCorners<InstantCorner>&, const InstantTriangle&) {
  return false;
}

namespace {

/// Two neighbours at one time.
class Neighbours {
 public:
  Neighbours(InstantSigns& signs, const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b)
      : signs_(signs),
        corners_a_{InstantCorner{&signs, 0}, {&signs, 1}, {&signs, 2}},
        corners_b_{InstantCorner{&signs, 3}, {&signs, 4}, {&signs, 5}},
        a_{corners_a_, a.vertices},
        b_{corners_b_, b.vertices} {}

  bool intersect() const { return surface_corners_intersect<InstantCorner>(a_, b_); }

  void find_features(FirstMeeting& meeting) const {
    const bool is_found =
        find_feature_pair(meeting.a, meeting.b, [&](const auto& a, const auto& b) {
          return !have_shared_corner(a, b) && hulls_meet(signs_, a, b);
        });
    if (!is_found) meeting.a = meeting.b = ClosedFeature{};
  }

 private:
  bool have_shared_corner(const CornerNumbers& of_a, const CornerNumbers& of_b) const {
    return std::any_of(of_a.begin(), of_a.end(), [&](std::size_t i) {
      return std::any_of(of_b.begin(), of_b.end(),
                         [&](std::size_t k) { return is_same_corner(a_, i, b_, k - 3); });
    });
  }

  InstantSigns& signs_;
  InstantTriangle corners_a_, corners_b_;
  SurfaceCornersOf<InstantCorner> a_, b_;
};

/// The search of the first time of one pair.
class FirstTime {
 public:
  FirstTime(const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b)
      : a_(a), b_(b), points_(moving_points(a.corners, b.corners)), polynomials_(points_) {}

  std::optional<FirstMeeting> find() {
    if (holds_at(0, Moment::at)) {
      FirstMeeting at_start;
      at_start.at_start = true;
      return at_start;
    }
    if (holds_at(0, Moment::after)) return meeting_;
    if (find_candidate() || holds_at(1, Moment::at)) return meeting_;
    return std::nullopt;
  }

 private:
  /// If the triangles intersect, sets time and features.
  bool holds_at(float time, Moment moment) {
    const Dyadic instant = dyadic(static_cast<double>(time));
    InstantSigns signs(polynomials_, instant, moment);
    if (!intersect(signs)) return false;
    meeting_.time = time;
    Neighbours(signs, a_, b_).find_features(meeting_);
    return true;
  }

  bool find_candidate() {
    const Candidates candidates(polynomials_);
    const Candidate* first = first_of(candidates, [&](const Candidate& candidate) {
      InstantSigns at(polynomials_, candidate.time, candidate.polynomial);
      if (intersect(at)) return true;
      InstantSigns after(polynomials_, candidate.time);
      return intersect(after);
    });
    if (first == nullptr) return false;
    meeting_.time = first->time.rounded_down();
    InstantSigns at(polynomials_, first->time, first->polynomial);
    InstantSigns after(polynomials_, first->time);
    Neighbours(intersect(at) ? at : after, a_, b_).find_features(meeting_);
    return true;
  }

  bool intersect(InstantSigns& signs) const { return Neighbours(signs, a_, b_).intersect(); }

  const MovingSurfaceTriangle &a_, &b_;
  MovingPoints points_;
  MovingPolynomials polynomials_;
  FirstMeeting meeting_;
};

}  // namespace

std::optional<FirstMeeting> first_meeting_of_neighbours(const MovingSurfaceTriangle& a,
                                                        const MovingSurfaceTriangle& b) {
  return FirstTime(a, b).find();
}

}  // namespace pelt::detail
