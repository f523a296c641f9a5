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
/// before t. If it lies in the plane of the face, or if the face has collapsed, an end of the
/// common part is an end of the edge or a point of an edge of the other.
#include "geometry/moving_pair.hpp"

#include "geometry/instant_signs.hpp"
#include "geometry/pair_by_signs.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace pelt::detail {
namespace {

// Functions that the template of the triangle pair test calls.

/// A corner of two moving triangles, at one time.
struct InstantCorner {
  InstantSigns* signs = nullptr;
  std::size_t corner = 0;
};

struct FlatInstantCorner {
  InstantSigns* signs = nullptr;
  std::size_t corner = 0, axis = 0;
};

using InstantTriangle = std::array<InstantCorner, 3>;

/// Returns -1, 0 or 1 if the coordinate of p is less than, equal to or greater than that of q.
int compare(const InstantCorner& p, const InstantCorner& q, std::size_t axis) {
  return p.signs->of(MovingPolynomials::compare(axis, q.corner, p.corner));
}

bool all_before(const InstantTriangle& a, const InstantTriangle& b, std::size_t axis) {
  return std::all_of(a.begin(), a.end(), [&](const InstantCorner& p) {
    return std::all_of(b.begin(), b.end(),
                       [&](const InstantCorner& q) { return compare(p, q, axis) < 0; });
  });
}

bool disjoint_boxes(const InstantTriangle& a, const InstantTriangle& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (all_before(a, b, axis) || all_before(b, a, axis)) return true;
  return false;
}

int orient3d(const InstantCorner& p, const InstantCorner& q, const InstantCorner& r,
             const InstantCorner& s) {
  return p.signs->of(MovingPolynomials::orient3d({p.corner, q.corner, r.corner, s.corner}));
}

PlaneSides sides_of(const InstantTriangle& corners, const InstantTriangle& plane) {
  const auto side = [&](const InstantCorner& p) {
    return orient3d(plane[0], plane[1], plane[2], p);
  };
  return {side(corners[0]), side(corners[1]), side(corners[2])};
}

FlatInstantCorner without(const InstantCorner& p, int axis) {
  return {p.signs, p.corner, static_cast<std::size_t>(axis)};
}

int orient2d(const FlatInstantCorner& p, const FlatInstantCorner& q, const FlatInstantCorner& r) {
  return p.signs->of(MovingPolynomials::orient2d(p.axis, {p.corner, q.corner, r.corner}));
}

bool lexicographically_less(const InstantCorner& p, const InstantCorner& q) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const int order = compare(p, q, axis)) return order < 0;
  return false;
}

bool flat_triangles_intersect(const InstantTriangle& a, const InstantTriangle& b) {
  return flat_corners_intersect(a, b);
}

bool segment_meets_triangle(const InstantTriangle& collapsed, const InstantTriangle& triangle) {
  return segment_meets_corners(collapsed, triangle);
}

/// Whether the hulls of two triples of corners intersect, given by their numbers of six.
bool hulls_meet(InstantSigns& signs, const std::array<std::size_t, 3>& a,
                const std::array<std::size_t, 3>& b) {
  const auto corner = [&](std::size_t i) { return InstantCorner{&signs, i}; };
  return corners_intersect(InstantTriangle{corner(a[0]), corner(a[1]), corner(a[2])},
                           InstantTriangle{corner(b[0]), corner(b[1]), corner(b[2])});
}

bool triangles_meet(InstantSigns& signs) { return hulls_meet(signs, {0, 1, 2}, {3, 4, 5}); }

// Features.

using Kind = ClosedFeature::Kind;

/// The corners of a feature, of which some are repeated. `first` is 0 for triangle a, 3 for b.
std::array<std::size_t, 3> corners_of(const ClosedFeature& feature, std::size_t first) {
  const std::size_t i = feature.number, next = (i + 1) % 3;
  switch (feature.kind) {
    case Kind::corner:
      return {first + i, first + i, first + i};
    case Kind::edge:
      return {first + i, first + next, first + next};
    case Kind::face:
      break;
  }
  return {first, first + 1, first + 2};
}

void find_features(InstantSigns& signs, FirstMeeting& meeting) {
  constexpr std::array<std::array<Kind, 2>, 6> kOrder = {{{Kind::corner, Kind::corner},
                                                          {Kind::corner, Kind::edge},
                                                          {Kind::edge, Kind::corner},
                                                          {Kind::corner, Kind::face},
                                                          {Kind::face, Kind::corner},
                                                          {Kind::edge, Kind::edge}}};
  const auto count = [](Kind kind) { return kind == Kind::face ? 1 : 3; };
  for (const auto& [kind_a, kind_b] : kOrder)
    for (int i = 0; i < count(kind_a); ++i)
      for (int k = 0; k < count(kind_b); ++k) {
        meeting.a = {kind_a, static_cast<std::uint8_t>(i)};
        meeting.b = {kind_b, static_cast<std::uint8_t>(k)};
        if (hulls_meet(signs, corners_of(meeting.a, 0), corners_of(meeting.b, 3))) return;
      }
  PELT_ASSERT(false);
}

// Times.

struct Candidate {
  CriticalTime time;
  std::size_t polynomial = MovingPolynomials::kCount;  ///< a polynomial with a root then, if known
};

/// Critical times of all polynomials of one degree: at most 45, 120 or 45.
class Candidates {
 public:
  explicit Candidates(MovingPolynomials& polynomials) {
    constexpr std::size_t kFlat = MovingPolynomials::kOrient3d;
    constexpr std::size_t kInLine = kFlat + MovingPolynomials::kOrient2d;
    if (!add(polynomials, 0, kFlat) && !add(polynomials, kFlat, kInLine))
      add(polynomials, kInLine, MovingPolynomials::kCount);
    for (std::size_t i = 0; i < count_; ++i) order_[i] = &candidates_[i];
    std::sort(
        order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(count_),
        [](const Candidate* p, const Candidate* q) { return p->time.above() < q->time.above(); });
  }

  /// In ascending order of their lower bounds.
  std::span<const Candidate* const> ordered() const { return {order_.data(), count_}; }

 private:
  /// Returns false if all of these polynomials are zero.
  bool add(MovingPolynomials& polynomials, std::size_t begin, std::size_t end) {
    bool any = false;
    CriticalTimes found;
    for (std::size_t number = begin; number < end; ++number) {
      any = any || !is_zero(polynomials[number]);
      find_critical_times(polynomials[number], found);
      for (std::size_t i = 0; i < found.count; ++i) {
        const auto& [time, is_root] = found.entries[i];
        candidates_[count_++] = {time, is_root ? number : MovingPolynomials::kCount};
      }
    }
    return any;
  }

  std::array<Candidate, 120> candidates_;
  std::array<const Candidate*, 120> order_{};
  std::size_t count_ = 0;
};

/// The first candidate at which the triangles meet; null if there is none.
const Candidate* first_of(const Candidates& candidates, MovingPolynomials& polynomials) {
  const Candidate* first = nullptr;
  for (const Candidate* candidate : candidates.ordered()) {
    if (first != nullptr && first->time.below() <= candidate->time.above()) break;
    if (first != nullptr && candidate->time.compare(first->time) >= 0) continue;
    InstantSigns signs(polynomials, candidate->time, candidate->polynomial);
    if (triangles_meet(signs)) first = candidate;
  }
  return first;
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
  if (const Candidate* first = first_of(candidates, polynomials)) {
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
  const Candidate* first = first_of(candidates, polynomials);
  PELT_ASSERT(first != nullptr);
  return first->time;
}

}  // namespace pelt::detail
