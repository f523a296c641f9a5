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

#include "geometry/neighbour_pair.hpp"

#include "geometry/predicates.hpp"

namespace pelt::detail {
namespace {

bool is_same_corner(const SurfaceTriangle& a, std::size_t i, const SurfaceTriangle& b,
                    std::size_t k) {
  return a.vertices[i] == b.vertices[k] && a.corners[i] == b.corners[k];
}

/// Whether the first `count` corners of `t` include this corner.
bool has_corner(const SurfaceTriangle& t, std::size_t count, const SurfaceTriangle& of,
                std::size_t corner) {
  for (std::size_t i = 0; i < count; ++i)
    if (is_same_corner(t, i, of, corner)) return true;
  return false;
}

/// The distinct corners of a triangle.
struct Distinct {
  Distinct(const SurfaceTriangle& of, const SurfaceTriangle& other) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!has_corner(of, i, of, i))
        (has_corner(other, 3, of, i) ? shared[shared_count++] : own[own_count++]) = of.corners[i];
  }

  Vec3 shared[3], own[3];
  std::size_t shared_count = 0, own_count = 0;
};

/// Whether the own corner, or the edge between the two own corners, meets the other triangle.
bool own_part_meets(const Distinct& part, const SurfaceTriangle& other) {
  if (part.own_count == 0) return false;
  return triangles_intersect({part.own[0], part.own[part.own_count - 1], part.own[0]},
                             other.corners);
}

/// Whether c and d lie in one plane with u and v, strictly on the same side of the line uv.
bool is_folded_flat(const Vec3& u, const Vec3& v, const Vec3& c, const Vec3& d) {
  if (orient3d(u, v, c, d) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2d from = without(u, axis), to = without(v, axis);
    if (const int side = orient2d(from, to, without(c, axis)))
      return orient2d(from, to, without(d, axis)) == side;
  }
  return false;  // u, v and c are on one line
}

/// Whether all own corners are strictly on one side of the other triangle's plane. Decides most
/// pairs of neighbours: no rule of the table then holds. A triangle with a plane has not collapsed,
/// and the first triangle meets the plane only in the hull of the shared corners. No own corner or
/// opposite edge of the other triangle reaches this hull: a shared corner or the shared edge.
bool own_part_is_aside(const Distinct& part, const SurfaceTriangle& other) {
  if (part.own_count == 0) return false;
  const OrientedPlane plane(other.corners[0], other.corners[1], other.corners[2]);
  const int side = plane.side(part.own[0]);
  return side != 0 && (part.own_count == 1 || plane.side(part.own[1]) == side);
}

}  // namespace

bool surface_triangles_intersect(const SurfaceTriangle& a, const SurfaceTriangle& b) {
  const Distinct of_a(a, b), of_b(b, a);
  if (of_a.shared_count == 0) return triangles_intersect(a.corners, b.corners);
  if (of_a.own_count == 0 && of_b.own_count == 0) return true;
  if (own_part_is_aside(of_a, b) || own_part_is_aside(of_b, a)) return false;
  if (own_part_meets(of_a, b) || own_part_meets(of_b, a)) return true;
  return of_a.shared_count == 2 && of_a.own_count == 1 && of_b.own_count == 1 &&
         is_folded_flat(of_a.shared[0], of_a.shared[1], of_a.own[0], of_b.own[0]);
}

}  // namespace pelt::detail
