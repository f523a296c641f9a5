/// The exact triangle pair test (Guigue & Devillers, "Fast and robust triangle-triangle overlap
/// test using orientation predicates", 2003): every decision is the sign of an orientation
/// determinant, so exact signs make an exact test.
///
/// Two triangles in general position whose planes cross in a line L intersect if the intervals in
/// which they cut L overlap. Turn each triangle so that its corner p, the apex, is alone on its
/// side of the other's plane: the interval then ends where the edges pq and pr cross L. Which of
/// two such ends comes first along L is again the side of an edge: with the apexes in front of the
/// other's plane (n2 (q1 - p1) < 0, n1 (q2 - p2) < 0), points i on p1q1 and k on p2q2, and D = n1 x
/// n2,
///   orient3d(p1, q1, p2, q2) = -((q1 - p1) x (q2 - p2)) (k - i),
///   ((q1 - p1) x (q2 - p2)) D = -(n2 (q1 - p1)) (n1 (q2 - p2)) < 0,
/// so it is positive if k comes after i in the direction D. The same direction has p1r1 before p1q1
/// and p2q2 before p2r2.
#include "geometry/triangle_pair.hpp"

#include "geometry/flat_pair.hpp"
#include "geometry/predicates.hpp"

#include <algorithm>
#include <utility>

namespace pelt::detail {
namespace {

/// On which side of a plane the three corners of a triangle are.
struct Sides {
  int p, q, r;

  bool all_on_one_open_side() const { return p != 0 && p == q && q == r; }
  bool all_on_plane() const { return p == 0 && q == 0 && r == 0; }
};

Sides sides_of(const TriangleCorners& corners, const TriangleCorners& plane) {
  const OrientedPlane oriented(plane[0], plane[1], plane[2]);
  return {oriented.side(corners[0]), oriented.side(corners[1]), oriented.side(corners[2])};
}

bool disjoint_range(float a0, float a1, float a2, float b0, float b1, float b2) {
  return std::max(std::max(a0, a1), a2) < std::min(std::min(b0, b1), b2) ||
         std::max(std::max(b0, b1), b2) < std::min(std::min(a0, a1), a2);
}

bool disjoint_boxes(const TriangleCorners& a, const TriangleCorners& b) {
  return disjoint_range(a[0].x, a[1].x, a[2].x, b[0].x, b[1].x, b[2].x) ||
         disjoint_range(a[0].y, a[1].y, a[2].y, b[0].y, b[1].y, b[2].y) ||
         disjoint_range(a[0].z, a[1].z, a[2].z, b[0].z, b[1].z, b[2].z);
}

/// A triangle in its own orientation, begun at its apex: the corner whose side, of the other's
/// plane, is less than the sides of both others or greater than both.
struct Apex {
  const Vec3 *p, *q, *r;
  bool behind;  ///< p is the corner further behind the plane, not the one in front

  Apex(const TriangleCorners& t, const Sides& s) : p(&t[0]), q(&t[1]), r(&t[2]) {
    int side_p = s.p, side_q = s.q;
    const bool all_differ = s.p != s.q && s.q != s.r && s.r != s.p;
    if (s.p == s.r || (all_differ && s.q > 0)) {
      p = &t[1], q = &t[2], r = &t[0], side_p = s.q, side_q = s.r;
    } else if (s.p == s.q || (all_differ && s.r > 0)) {
      p = &t[2], q = &t[0], r = &t[1], side_p = s.r, side_q = s.p;
    }
    behind = side_p < side_q;
  }
};

/// Whether the triangles' intervals on the line of their planes overlap.
bool intervals_overlap(Apex a, Apex b) {
  if (a.behind) std::swap(b.q, b.r);  // turns b's plane round
  if (b.behind) std::swap(a.q, a.r);
  return orient3d(*a.p, *a.q, *b.p, *b.q) <= 0 && orient3d(*a.p, *a.r, *b.p, *b.r) >= 0;
}

}  // namespace

bool triangles_intersect(const TriangleCorners& a, const TriangleCorners& b) {
  if (disjoint_boxes(a, b)) return false;
  const Sides sides_a = sides_of(a, b);
  if (sides_a.all_on_one_open_side()) return false;
  const Sides sides_b = sides_of(b, a);
  if (sides_b.all_on_one_open_side()) return false;

  // A corner off the other's plane proves that the other has not collapsed.
  if (sides_a.all_on_plane() && sides_b.all_on_plane()) return flat_triangles_intersect(a, b);
  if (sides_a.all_on_plane()) return segment_meets_triangle(b, a);
  if (sides_b.all_on_plane()) return segment_meets_triangle(a, b);
  return intervals_overlap(Apex(a, sides_a), Apex(b, sides_b));
}

}  // namespace pelt::detail
