/// Self-intersection of triangles that share corners.
///
/// Let A and B be the closed triangles, and let neither have collapsed. A and B are convex, so
/// their intersection is convex.
///
/// One shared corner v. If A and B have another common point x, both contain the segment from v to
/// x. Extend it beyond x until it leaves A or B. It leaves a triangle at the edge opposite v,
/// because it starts at v. The point where it leaves the first of the two triangles belongs to
/// both, so one opposite edge meets the other triangle. Conversely, an opposite edge does not
/// contain v, so a point of it that belongs to the other triangle is another common point.
///
/// Two shared corners u and v, third corners p of A and q of B. If q is not in the plane of A, the
/// planes cross in the line uv, and each triangle meets this line only in the shared edge. If all
/// corners are in one plane, the line uv separates the triangles if p and q are on different sides.
/// If they are on the same side, the triangles overlap: near an interior point of the edge, both
/// contain all points on that side. Neither p nor q is on the line, as neither triangle has
/// collapsed. The rule about third corners then adds nothing: p in B implies one plane and the same
/// side.
///
/// Collapsed triangles. The rules are the definition. They report a segment that passes through a
/// shared corner, or whose third corner lies on the shared edge: there, a corner or an edge of one
/// triangle lies on a part of the other that it does not share. Without the rule about third
/// corners, two segments that extend the shared edge on the same side would not be reported.

#include "self/neighbours.hpp"

#include "base/vec3.hpp"
#include "exact/predicates.hpp"
#include "geometry/pair_by_signs.hpp"
#include "motion/instants.hpp"
#include "motion/moving_filter.hpp"
#include "self/neighbour_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {

// The test is a template over points, as in `pair_by_signs.hpp`. In addition, it needs these
// functions:
//
//   coincide(p, q)          whether two corners are at one position
//   is_aside(part, other)   a quick test that proves that no rule holds, or false

static bool coincide(const Vec3& p, const Vec3& q) { return p == q; }

/// A triangle with the surface vertices of its corners.
template <typename Point>
struct SurfaceCornersOf {
  const CornersOf<Point>& corners;
  const std::array<std::uint32_t, 3>& vertices;
};

template <typename Point>
static bool is_same_corner(const SurfaceCornersOf<Point>& a, std::size_t i,
                           const SurfaceCornersOf<Point>& b, std::size_t k) {
  return a.vertices[i] == b.vertices[k] && coincide(a.corners[i], b.corners[k]);
}

/// The distinct corners of a triangle: those that the other triangle shares, and its own.
template <typename Point>
struct DistinctCorners {
  DistinctCorners(const SurfaceCornersOf<Point>& of, const SurfaceCornersOf<Point>& other) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!has_corner(of, i, of, i))
        (has_corner(other, 3, of, i) ? shared[shared_count++] : own[own_count++]) = of.corners[i];
  }

  Point shared[3], own[3];
  std::size_t shared_count = 0, own_count = 0;

 private:
  /// Whether the first `count` corners of `t` include this corner.
  static bool has_corner(const SurfaceCornersOf<Point>& t, std::size_t count,
                         const SurfaceCornersOf<Point>& of, std::size_t corner) {
    for (std::size_t i = 0; i < count; ++i)
      if (is_same_corner(t, i, of, corner)) return true;
    return false;
  }
};

/// Whether the own corner, or the edge between the two own corners, meets the other triangle.
template <typename Point>
static bool own_part_meets(const DistinctCorners<Point>& part, const CornersOf<Point>& other) {
  if (part.own_count == 0) return false;
  return corners_intersect(CornersOf<Point>{part.own[0], part.own[part.own_count - 1], part.own[0]},
                           other);
}

/// Whether c and d lie in one plane with u and v, strictly on the same side of the line uv.
template <typename Point>
static bool is_folded_flat(const Point& u, const Point& v, const Point& c, const Point& d) {
  if (orient3d(u, v, c, d) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto from = without(u, axis), to = without(v, axis);
    if (const int side = orient2d(from, to, without(c, axis)))
      return orient2d(from, to, without(d, axis)) == side;
  }
  return false;  // u, v and c are on one line
}

template <typename Point>
static bool surface_corners_intersect(const SurfaceCornersOf<Point>& a,
                                      const SurfaceCornersOf<Point>& b) {
  const DistinctCorners<Point> of_a(a, b), of_b(b, a);
  if (of_a.shared_count == 0) return corners_intersect(a.corners, b.corners);
  if (of_a.own_count == 0 && of_b.own_count == 0) return true;
  if (is_aside(of_a, b.corners) || is_aside(of_b, a.corners)) return false;
  if (own_part_meets(of_a, b.corners) || own_part_meets(of_b, a.corners)) return true;
  return of_a.shared_count == 2 && of_a.own_count == 1 && of_b.own_count == 1 &&
         is_folded_flat(of_a.shared[0], of_a.shared[1], of_a.own[0], of_b.own[0]);
}

/// Whether all own corners are strictly on one side of the other triangle's plane. Decides most
/// pairs of neighbours: no rule of the table in neighbours.hpp then holds. A triangle with a plane
/// has not collapsed, and the first triangle meets the plane only in the hull of the shared
/// corners. No own corner or opposite edge of the other triangle reaches this hull: a shared corner
/// or the shared edge.
static bool is_aside(const DistinctCorners<Vec3>& part, const TriangleCorners& other) {
  if (part.own_count == 0) return false;
  const OrientedPlane plane(other[0], other[1], other[2]);
  const int side = plane.side(part.own[0]);
  return side != 0 && (part.own_count == 1 || plane.side(part.own[1]) == side);
}

bool surface_triangles_intersect(const SurfaceTriangle& a, const SurfaceTriangle& b) {
  return surface_corners_intersect<Vec3>({a.corners, a.vertices}, {b.corners, b.vertices});
}

// While moving. Whether two triangles of a surface intersect is a function of the signs that
// `moving_pair.cpp` names, also with shared corners: each rule asks whether the hulls of some of
// the six corners intersect, whether two corners coincide, or on which sides of an edge two corners
// lie in a plane. Let no critical polynomial vanish on an open interval: no chi that is not
// identically zero; if all are, no psi; if these are, too, no lam. Then the answer is constant on
// the interval:
//   Hulls of any of the corners. A circuit of them extends to points that span the space, the
// plane or the line of all six, as in the proof there.
//   Coincidence. If two corners are apart at some time of the interval, they extend to points that
// span, and the critical polynomial of these is zero where the corners coincide.
//   Sides of an edge. This rule is asked about four distinct points in one plane; the polynomials
// are chi of these points, and psi or lam if all six corners are coplanar at all times.
// The answer is therefore asked at time 0, at the critical times, immediately after each of these,
// and at time 1. Unlike closed triangles without shared corners, neighbours may intersect after a
// critical time and not at it.

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
    if (!is_found) meeting.a = meeting.b = Feature{};
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
