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

#include "base/vec3.hpp"
#include "motion/instants.hpp"
#include "motion/moving_filter.hpp"
#include "self/neighbour_by_signs.hpp"
#include "self/neighbour_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

namespace {

// In double: halves the step until neighbours are certainly apart on all parts
// (neighbour_separation.hpp), or gives up. The ends of parts are multiples of 2^-kMostHalvings, so
// interpolation rounds as counted there.

constexpr int kMostHalvings = 10, kMostParts = 64;

/// For NeighbourSeparation.
struct DoubleKit {
  using Number = double;
  using Point = Vec3d;
  using Mask = unsigned;

  static double half() { return 0.5; }
  static double third() { return 1.0 / 3; }
  static double determinant_units() { return 0x1p-52; }  // 256 u V, of 128 V
  static double projection_units() { return 0x1p-53; }
  static double tiny() { return 0; }
  static double min(double x, double y) { return std::min(x, y); }
  static double max(double x, double y) { return std::max(x, y); }
  static double largest(const Vec3d& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
};

using Vector = MovingVector<Vec3d>;

Vector vector_to(const MovingTriangle& t, std::size_t corner, const MovingTriangle& origin,
                 std::size_t from) {
  return {Vec3d(t.from[corner]) - Vec3d(origin.from[from]),
          Vec3d(t.to[corner]) - Vec3d(origin.to[from])};
}

Vector part_of(const Vector& v, double start, double end) {
  return {between(start, v.from, v.to), between(end, v.from, v.to)};
}

EdgeNeighbours<Vec3d> part_of(const EdgeNeighbours<Vec3d>& pair, double start, double end) {
  return {part_of(pair.edge, start, end), part_of(pair.p, start, end), part_of(pair.q, start, end)};
}

CornerNeighbours<Vec3d> part_of(const CornerNeighbours<Vec3d>& pair, double start, double end) {
  const auto& [a, b] = pair;
  return {{part_of(a[0], start, end), part_of(a[1], start, end)},
          {part_of(b[0], start, end), part_of(b[1], start, end)}};
}

/// `Pair`: CornerNeighbours or EdgeNeighbours. Visits the parts in order of time.
template <typename Pair>
bool are_apart_on_all_parts(const Pair& pair) {
  struct Part {
    double start, end;
    int depth;
  };
  std::array<Part, kMostHalvings + 1> waiting;
  std::size_t count = 0;
  waiting[count++] = {0, 1, 0};
  for (int visited = 0; count > 0; ++visited) {
    const Part part = waiting[--count];
    if (NeighbourSeparation<DoubleKit>::are_apart(part_of(pair, part.start, part.end))) continue;
    if (part.depth == kMostHalvings || visited == kMostParts) return false;
    const double middle = (part.start + part.end) / 2;
    waiting[count++] = {middle, part.end, part.depth + 1};
    waiting[count++] = {part.start, middle, part.depth + 1};
  }
  return true;
}

/// Whether two corners have one surface vertex.
bool has_equal_corners(const std::array<std::uint32_t, 3>& v) {
  return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
}

/// Whether the closed triangles certainly never meet.
bool never_touch(const MovingTriangle& a, const MovingTriangle& b) {
  return certainly_intersect(a, b) == CertainAnswer::no;
}

SurfaceTriangle at_start(const MovingSurfaceTriangle& t) { return {t.corners.from, t.vertices}; }
SurfaceTriangle at_end(const MovingSurfaceTriangle& t) { return {t.corners.to, t.vertices}; }

}  // namespace

bool certainly_apart(const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b) {
  if (has_equal_corners(a.vertices) || has_equal_corners(b.vertices)) return false;
  const MovingTriangle &s = a.corners, &t = b.corners;
  const SharedCorners shared([&](std::size_t i, std::size_t k) {
    return a.vertices[i] == b.vertices[k] && s.from[i] == t.from[k] && s.to[i] == t.to[k];
  });
  const auto of_a = [&](std::size_t i) { return vector_to(s, shared.a[i], s, shared.a[0]); };
  const auto of_b = [&](std::size_t k) { return vector_to(t, shared.b[k], s, shared.a[0]); };
  switch (shared.count) {
    case 0:
      return never_touch(s, t);
    case 1:
      return are_apart_on_all_parts(
          CornerNeighbours<Vec3d>{{of_a(1), of_a(2)}, {of_b(1), of_b(2)}});
    case 2:
      return are_apart_on_all_parts(EdgeNeighbours<Vec3d>{of_a(1), of_a(2), of_b(2)});
    default:
      return false;
  }
}

std::optional<MovingContact> decide_neighbours(const MovingSurfaceTriangle& a,
                                               const MovingSurfaceTriangle& b,
                                               const Contact& contact, const MovingOptions& options,
                                               MovingStats& work) {
  ++work.double_pairs;
  if (certainly_apart(a, b)) return std::nullopt;
  if (surface_triangles_intersect(at_start(a), at_start(b))) {
    if (options.leave_out_start) return std::nullopt;
    return MovingContact{contact, 0, options.times, {}, {}};
  }
  const MovingContact untimed = {contact, 0, false, {}, {}};
  if (!options.times && surface_triangles_intersect(at_end(a), at_end(b))) return untimed;
  ++work.exact_pairs;
  const std::optional<FirstMeeting> first = first_meeting_of_neighbours(a, b);
  if (!first) return std::nullopt;
  return options.times ? moving_contact(contact, *first) : untimed;
}

}  // namespace pelt::detail
