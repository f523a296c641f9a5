#include "volume/generic_crossing.hpp"
#include "base/assert.hpp"
#include "exact/exact_determinant.hpp"
#include "exact/predicates.hpp"
#include "geometry/generic_ray.hpp"

#include <cmath>

namespace pelt::detail {
namespace {

/// det(plane[1] - plane[0], plane[2] - plane[0], point - plane[0]), rounded once.
Rounded exact_height(const TriangleCorners& plane, const Vec3& point) {
  const double value =
      exact_orientation(Vec3d(plane[0]), Vec3d(plane[1]), Vec3d(plane[2]), Vec3d(point));
  return Rounded::within(value, 0x1p-52 * std::abs(value));
}

}  // namespace

Rounded share_before_plane(const Vec3& from, const Vec3& to, const TriangleCorners& plane) {
  using V = Vector<Rounded>;
  const V normal = cross(V(plane[1]) - V(plane[0]), V(plane[2]) - V(plane[0]));
  const Rounded height = dot(normal, V(from) - V(plane[0]));
  const Rounded difference = dot(normal, V(from) - V(to));
  constexpr double kEnough = 0x1p-43;
  if (height.error() + difference.error() < kEnough * std::abs(difference.value()))
    return height / difference;
  const Rounded exact = exact_height(plane, from);
  return exact / (exact - exact_height(plane, to));
}

namespace {

std::size_t next(std::size_t corner) { return (corner + 1) % 3; }

/// The sign of det(b - a, d - c, k) for the generic direction k.
int generic_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  for (const Vec3& direction : kGenericDirection) {
    const int sign = exact_sign([&](auto number) {
      using V = Vector<decltype(number)>;
      return dot(cross(V(b) - V(a), V(d) - V(c)), V(direction));
    });
    if (sign != 0) return sign;
  }
  return 0;
}

/// The sign of det(b - a, c - a, d - a). Corners coincide in neighbours and in copies of triangles;
/// exact arithmetic would take long to find that.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (d == a || d == b || d == c) return 0;
  return orient3d(a, b, c, d);
}

/// Sides of the corners of `t` relative to the plane of `of`: 1 in front, -1 behind, 0 if `of` has
/// collapsed. `motion` is 1 if `t` is moved along the generic direction, -1 if `of` is.
std::array<int, 3> generic_sides(const TriangleCorners& t, const TriangleCorners& of, int motion) {
  std::array<int, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = orientation(of[0], of[1], of[2], t[i]);
    if (sides[i] == 0) sides[i] = motion * generic_sign(of[0], of[1], of[0], of[2]);
  }
  return sides;
}

/// The orientation of the line through an edge of `a` and the line through an edge of `b`.
int generic_turn(const TriangleCorners& a, std::size_t edge_a, const TriangleCorners& b,
                 std::size_t edge_b) {
  const Vec3 &p = a[edge_a], &q = a[next(edge_a)], &r = b[edge_b], &s = b[next(edge_b)];
  const int turn = r == p || r == q ? 0 : orientation(p, q, r, s);
  return turn != 0 ? turn : generic_sign(p, q, r, s);
}

/// Whether an edge of `a` passes all edges of `b` on the same side.
bool passes_through(const TriangleCorners& a, std::size_t edge, const TriangleCorners& b) {
  const int turn = generic_turn(a, edge, b, 0);
  return generic_turn(a, edge, b, 1) == turn && generic_turn(a, edge, b, 2) == turn;
}

/// The same with `a` and `b` exchanged.
bool is_passed_through(const TriangleCorners& a, const TriangleCorners& b, std::size_t edge) {
  const int turn = generic_turn(a, 0, b, edge);
  return generic_turn(a, 1, b, edge) == turn && generic_turn(a, 2, b, edge) == turn;
}

bool are_on_one_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

}  // namespace

/// An interval of a on the line of both planes begins where the outline of a comes to the front of
/// b, and an interval of b begins where the outline of b goes behind a (triangle_crossing.cpp).
std::optional<GenericCrossing> cross_generic(const TriangleCorners& a, const TriangleCorners& b) {
  const std::array<int, 3> sides_a = generic_sides(a, b, 1);
  if (are_on_one_side(sides_a)) return std::nullopt;
  const std::array<int, 3> sides_b = generic_sides(b, a, -1);
  if (are_on_one_side(sides_b)) return std::nullopt;
  GenericCrossing crossing;
  int count = 0;
  for (std::uint8_t edge = 0; edge < 3; ++edge) {
    const int side_a = sides_a[edge], side_b = sides_b[edge];
    if (side_a != sides_a[next(edge)] && passes_through(a, edge, b)) {
      crossing[side_a < 0 ? 0 : 1] = {true, edge, static_cast<std::int8_t>(side_a)};
      ++count;
    }
    if (side_b != sides_b[next(edge)] && is_passed_through(a, b, edge)) {
      crossing[side_b > 0 ? 0 : 1] = {false, edge, static_cast<std::int8_t>(side_b)};
      ++count;
    }
  }
  PELT_ASSERT(count == 0 || (count == 2 && crossing[0].inwards != 0 && crossing[1].inwards != 0));
  if (count == 0) return std::nullopt;
  return crossing;
}

Rounded share_of_edge(const Piercing& piercing, const TriangleCorners& a,
                      const TriangleCorners& b) {
  const TriangleCorners &own = piercing.is_edge_of_a ? a : b,
                        &other = piercing.is_edge_of_a ? b : a;
  return share_before_plane(own[piercing.edge], own[next(piercing.edge)], other);
}

}  // namespace pelt::detail
