/// Reduction to finitely many times. Six points move linearly; chi, psi and lam are the polynomials
/// of degree 3, 2 and 1 in `moving_polynomials.hpp`. Let the triangles be disjoint at time 0 and
/// meet first at time t.
///
///   (3) If not all chi vanish identically, t is a root of a chi that does not.
///   (2) If all chi do, but not all psi, t is a root of a psi that does not vanish identically.
///   (1) If all chi and psi do, t is a root of a lam that does not vanish identically.
///
/// Proof of (3). Suppose that no such chi vanishes at t. Then the signs of all chi are constant on
/// a neighbourhood N of t in [0, 1], and at least one is not 0, so on N the six points affinely
/// span space. Two hulls intersect if and only if some affine dependence, sum c_i p_i = 0 with sum
/// c_i = 0 and not all c_i = 0, has c_i >= 0 for the one triple and c_i <= 0 for the other. A
/// dependence is a sum of circuits (dependences of minimal support) whose signs agree with it, and
/// no nonempty part of a dependence with one sign sums to 0; so there is then also a circuit of
/// this form. Without one of its points, a circuit is independent and extends to four of the six
/// points that span space. By Cramer's rule, the signs of the circuit are signs of chi. Whether the
/// hulls intersect is therefore constant on N. But N contains times before t, at which they do not:
/// a contradiction.
///
/// Proof of (2). All points are coplanar at all times. Suppose that no such psi vanishes at t. One
/// of them, seen along an axis, is not 0 on N, so this axis is never parallel to the plane. On N,
/// the hulls therefore intersect if and only if their images along the axis do, and the argument of
/// (3) applies to these, with the psi of this axis. Proof of (1). All points are on one line at all
/// times. Suppose that no such lam vanishes at t. One of them is not 0 on N, so the order along its
/// axis decides, and it is constant. If all lam vanish identically, all points are equal at all
/// times, and meet at time 0.
///
/// The static test is therefore evaluated at the roots, with signs at the roots, and at time 1.
///
/// Features. At the first time t > 0, some pair of the list meets. If the interior of an edge
/// crossed the interior of a face with a corner on either side, both would still do so shortly
/// before t. If the edge lies in the plane of the face, or if the face has collapsed, an end of
/// the common part is an end of the edge or lies on an edge of the face.
#include "motion/moving_pair.hpp"

#include "motion/instants.hpp"

namespace pelt::detail {
namespace {

bool triangles_meet(InstantSigns& signs) { return hulls_meet(signs, {0, 1, 2}, {3, 4, 5}); }

const Candidate* first_meeting_candidate(const Candidates& candidates,
                                         MovingPolynomials& polynomials) {
  return first_of(candidates, [&](const Candidate& candidate) {
    InstantSigns signs(polynomials, candidate.time, candidate.polynomial);
    return triangles_meet(signs);
  });
}

void find_features(InstantSigns& signs, FirstMeeting& meeting) {
  [[maybe_unused]] const bool is_found = find_feature_pair(
      meeting.a, meeting.b, [&](const auto& a, const auto& b) { return hulls_meet(signs, a, b); });
  PELT_ASSERT(is_found);
}

}  // namespace

std::optional<FirstMeeting> first_meeting(const MovingPoints& points) {
  MovingPolynomials polynomials(points);
  const Dyadic start = dyadic(0), end = dyadic(1);
  FirstMeeting meeting;
  InstantSigns at_start(polynomials, start);
  meeting.at_start = triangles_meet(at_start);
  if (meeting.at_start) return meeting;

  const Candidates candidates(polynomials);
  if (const Candidate* first = first_meeting_candidate(candidates, polynomials)) {
    InstantSigns signs(polynomials, first->time, first->polynomial);
    meeting.time = first->time.rounded_down();
    find_features(signs, meeting);
    return meeting;
  }
  InstantSigns at_end(polynomials, end);
  if (!triangles_meet(at_end)) return std::nullopt;
  meeting.time = 1;
  find_features(at_end, meeting);
  return meeting;
}

std::optional<FirstMeeting> first_meeting(const MovingTriangle& a, const MovingTriangle& b) {
  return first_meeting(moving_points(a, b));
}

CriticalTime first_time_of(const MovingTriangle& a, const MovingTriangle& b) {
  const MovingPoints points = moving_points(a, b);
  MovingPolynomials polynomials(points);
  const Candidates candidates(polynomials);
  const Candidate* first = first_meeting_candidate(candidates, polynomials);
  PELT_ASSERT(first != nullptr);
  return first->time;
}

}  // namespace pelt::detail
