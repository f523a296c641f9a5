#pragma once

#include <pelt/config.hpp>

#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <vector>

namespace pelt {

/// Appends every pair of intersecting triangles of `a` and `b` to `contacts`, in ascending order.
///
/// The answer is exact with respect to the float32 posed vertices (see `posed_vertices`). Triangles
/// are closed sets: triangles that only touch, or that overlap in one plane, intersect. A triangle
/// that has collapsed to a segment or a point is treated as that segment or point.
///
/// Preconditions:
/// `a`, `b`: different poses, of one model or of two. Passing one pose twice aborts the program, in
///   every build.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: grows with the contact area and not with the size of the meshes. The trees of both poses
/// are descended together. Vertices are posed, and boxes are computed, only where boxes overlap.
/// Each node is opened at most once until the pose changes (see `Pose`). Poses that are
/// far apart cost O(J), plus at most O(J) for each morph weight other than 0.
///
/// `limits`: with `max_contacts` 0, the query finds no contact, and `QueryStats::cut_short` says
/// whether the boxes of the two poses overlap.
///
/// Allocates only if it needs more memory in the poses, in `scratch` or in `contacts` than any
/// earlier query.
///
/// Source: boxes are computed on demand as in section 4.2 of Kavan & Zara 2005. The tree and its
/// bounds are Pelt's own.
PELT_API QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                            const Limits& limits = {});

/// Returns whether any triangles of `a` and `b` intersect. Like `collide`, but stops at the first
/// contact.
PELT_API YesNo intersects(Pose& a, Pose& b, Scratch& scratch);

}  // namespace pelt
