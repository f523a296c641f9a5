#pragma once

/// Intersections of two triangles in general position, for any two triangles: a is moved by an
/// infinitesimal multiple h of the generic direction k of geometry/generic_ray.hpp.
///
/// With this, each sign below is the first nonzero one of two: that of the triangles as they are,
/// and that of its derivative in h. The derivative is k . n, where n is the normal of a triangle or
/// the cross product of an edge of each. Its sign is zero only if n = 0. Therefore
/// - a corner of one is never on the plane of the other, unless the other has collapsed, and
/// - if an edge passes through the plane of the other triangle, the edge is not parallel to any of
///   the other's edges, and passes each of them on a definite side.
/// An edge thus pierces a triangle between its edges, or misses it. A collapsed triangle is pierced
/// by nothing.
///
/// All decisions about all triangles of two surfaces are decisions about one configuration, so they
/// are consistent. Functions that are continuous in h, such as volumes, have the value at h = 0.

#include "exact/exact_number.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pelt::detail {

/// Returns where an edge crosses the plane of a triangle: 0 at `from`, 1 at `to`. Precondition:
/// `from` and `to` are on different sides of the plane, or one of them is on it.
Rounded share_before_plane(const Vec3& from, const Vec3& to, const TriangleCorners& plane);

/// Where an edge of one triangle pierces the other triangle. Edge i leads from corner i to the next
/// corner.
struct Piercing {
  bool is_edge_of_a = false;
  std::uint8_t edge = 0;
  std::int8_t inwards = 0;  ///< 1 if the edge leads to the back of the other triangle, otherwise -1
};

/// The segment in which two triangles intersect, from the first to the second end in the direction
/// n_a x n_b of their normals. If a triangle has collapsed, the ends are one point.
using GenericCrossing = std::array<Piercing, 2>;

/// Returns how two triangles intersect if `a` is moved by an infinitesimal multiple of
/// `kGenericDirection`; nullopt if they do not. Exact.
std::optional<GenericCrossing> cross_generic(const TriangleCorners& a, const TriangleCorners& b);

/// Where on its edge a piercing is, without the infinitesimal motion: 0 at the start of the edge, 1
/// at its end. Precondition: the piercing belongs to the crossing of `a` and `b`.
Rounded share_of_edge(const Piercing& piercing, const TriangleCorners& a, const TriangleCorners& b);

}  // namespace pelt::detail
