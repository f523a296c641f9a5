#pragma once

/// Volumes of closed bodies: of one body, of its overlap with itself, and of the intersection of
/// two. The surfaces need not be
/// free of intersections with themselves: all volumes are integrals of winding numbers, see
/// `side_of`.

#include <pelt/cxx20.hpp>

#include <pelt/contact.hpp>
#include <pelt/export.hpp>

namespace pelt {

/// A volume, in cubed units of the joint palette's frame.
struct Volume {
  double value = 0;

  /// The exact volume of the float32 posed surfaces differs from `value` by at most `error`. The
  /// bound covers all roundings.
  double error = 0;
};

/// Writes the volume that the posed surface encloses: the integral of its winding number w over
/// space. A region around which the surface winds twice counts twice. A region that the surface
/// encloses inside out, with w = -1, counts negatively, as does the whole body in a mirrored pose
/// or if its triangles are clockwise.
///
/// Error: stated in the result. About 2^-53 T times the volume of the bounding box.
///
/// Preconditions (otherwise the program aborts, in every build):
/// `surface`: closed, and of the model of `pose`.
///
/// Cost: O(V + T). Opens all nodes.
PELT_API QueryStats volume(Pose& pose, const Surface& surface, Volume& result);

/// Writes the volume of the intersection of a body with itself: the integral of w (w - 1) / 2 over
/// space, where w is the winding number of the posed surface. Where the body overlaps itself once,
/// w is 2, and the region counts once. With w = 3, three pairs of layers overlap, and the region
/// counts three times. A region that is inside out, with w = -1, counts once, too. The result is 0
/// if the surface does not intersect itself, apart from the stated error.
///
/// The polynomial, unlike max(w - 1, 0), is a sum over pairs of layers. It needs no arrangement of
/// the surface, and adds up: for two bodies in one mesh, the result is the sum for both bodies plus
/// their `intersection_volume`.
///
/// All decisions are exact: which edge pierces which triangle, and the winding number in front of
/// each triangle. Where parts of the surface touch without crossing, or coincide, the query decides
/// as if each vertex had been moved by an infinitesimal vector of its own. The volume depends
/// continuously on these vectors, so the result is exact also for such surfaces, apart from
/// rounding.
///
/// Error: stated in the result. About 2^-53 n times the volume of a box around all triangles that
/// contribute, where n is their number: those that cross others, and those with w != 0 in front.
///
/// Preconditions (otherwise the program aborts, in every build):
/// `surface`: closed, and of the model of `pose`. The model has at most 2^28 triangles.
///
/// Cost: that of `self_collide` without a filter, O(T + C log C) for C pairs of intersecting
/// triangles, and one ray for each connected part of the surface. Opens all nodes. Pairs that only
/// touch cost several times as much as others.
///
/// The first query with a surface also takes 1.5 times as long as `build_self_filter`, and
/// allocates 44 to 57 bytes per triangle of a character, which copies of the surface share. For
/// `Scratch::reserve`, contacts are those of `self_collide`. Pairs of triangles also count as
/// contacts if they have corners in one position that are one surface vertex, but have different
/// influences.
///
/// Source: winding numbers spread over the surface from one triangle of each connected part, as in
/// Zhou et al., "Mesh arrangements for solid geometry" (2016), but the surface is never cut. The
/// perturbation is that of Edelsbrunner & Muecke, "Simulation of simplicity" (1990).
PELT_API QueryStats self_intersection_volume(Pose& pose, const Surface& surface, Scratch& scratch,
                                             Volume& result);

/// Writes the volume of the intersection of two bodies: the integral of w_a w_b over space, where
/// w_a and w_b are the winding numbers of the posed surfaces. If neither surface intersects itself,
/// and neither is inside out, this is the volume of the points inside both bodies. Where a surface
/// overlaps itself, its winding number counts how often; with a product of winding numbers, the
/// volume is the sum of the volumes for the connected parts of `a` and `b`.
///
/// All decisions are exact: which edge pierces which triangle, and the winding number at each
/// vertex. Where features of `a` and `b` touch without crossing, such as two faces in one plane,
/// the query decides as if `a` had been moved by an infinitesimal vector. The volume depends
/// continuously on that vector, so the result is exact also for such bodies, apart from rounding.
///
/// Error: stated in the result. About 2^-53 n times the volume of a box around all triangles that
/// contribute, where n is their number. Exchanging `a` and `b` may change the result within the
/// stated errors.
///
/// Preconditions (otherwise the program aborts, in every build):
/// `a`, `b`: different poses.
/// `surface_a`, `surface_b`: closed, and of the models of `a` and `b`.
///
/// Cost: that of `collide`, and O(C log C) for C pairs of intersecting triangles. The query then
/// tests the boxes of each body against the surface of the other body, and casts one ray for each
/// box that does not touch the surface. Boxes outside are skipped with everything inside them.
/// Everything else is posed, because each of its triangles contributes.
///
/// Source: the divergence theorem turns the volume into integrals over the parts of either surface
/// inside the other body; these into integrals along edges and segments of intersection, as in
/// W. R. Franklin, "Polygon properties calculated from the vertex neighborhoods" (1987). The parts
/// are never constructed. The perturbation is that of Edelsbrunner & Muecke, "Simulation of
/// simplicity" (1990).
PELT_API QueryStats intersection_volume(Pose& a, const Surface& surface_a, Pose& b,
                                        const Surface& surface_b, Scratch& scratch, Volume& result);

}  // namespace pelt
