#pragma once

/// A ray in general position from any point: it meets no edge of any triangle, for any number and
/// any positions of triangles.
///
/// The ray has the direction d(e) = k0 + e k1 + e^2 k2 for all small enough e > 0, where k0, k1, k2
/// are linearly independent (`kGenericDirection`). An edge from q to r passes the ray on the side
/// of
///
///     det(d(e), q - o, r - o) = det(k0, ..) + e det(k1, ..) + e^2 det(k2, ..),
///
/// whose sign is the sign of the first nonzero term. All three terms are zero only if (q - o) x (r
/// - o) = 0, that is, if o, q and r are on one line. For a triangle whose plane does not contain o,
/// every edge therefore passes on a definite side, and the ray either pierces the triangle away
/// from its edges or misses it (simulation of simplicity, Edelsbrunner & Muecke 1990). A second ray
/// is never needed.
///
/// The ray along k0 itself meets, as closed sets, every triangle that the generic ray pierces: as e
/// goes to zero, the pierced points converge to a point of the triangle and of the ray. A search
/// along k0 that finds all closed triangles that are not parallel to k0 therefore finds all
/// triangles that can be pierced, except those parallel to k0. The planes of these contain o, so no
/// ray from o that misses o pierces them.

#include "geometry/ray_triangle.hpp"

#include <array>

namespace pelt::detail {

/// k0, k1, k2.
using GenericDirection = std::array<Vec3, 3>;

/// Not parallel to planes that triangles are usually placed in, so k0 alone nearly always decides.
inline constexpr GenericDirection kGenericDirection = {
    {{0.8391f, 0.4772f, 0.2613f}, {-0.3178f, 0.8845f, 0.3417f}, {0.1239f, -0.4381f, 0.8903f}}};

inline constexpr GenericDirection kOppositeDirection = {
    {{-0.8391f, -0.4772f, -0.2613f}, {0.3178f, -0.8845f, -0.3417f}, {-0.1239f, 0.4381f, -0.8903f}}};

/// Returns how the generic ray from `origin` pierces a triangle, given the `crossing` of the
/// triangle with the line from `origin` along k0: 1 from its back, -1 from its front, 0 not at all.
/// Does not count triangles whose planes contain `origin`, as if the ray began an infinitesimal
/// step after `origin`. Exact.
int pierce_from_back(const Vec3& origin, const GenericDirection& direction,
                     const TriangleCorners& triangle, const RayCrossing& crossing);

}  // namespace pelt::detail
