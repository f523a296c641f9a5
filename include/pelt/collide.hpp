#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelt {

/// Two triangles that intersect, by their numbers in the two models' triangle arrays.
struct Contact {
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const Contact&, const Contact&) = default;
};

struct CollideOptions {
  /// Stop after this many contacts. Which ones are found first is unspecified, and
  /// `QueryStats::cut_short` says whether any may be missing. 0 is allowed: nothing is looked for,
  /// and `cut_short` says whether the boxes around the two poses overlap.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();
};

/// Appends every pair of triangles of `a` and `b` that intersect, in ascending order.
///
/// Exact with respect to the float32 posed vertices (see `posed_vertices`): triangles are closed
/// sets, so touching counts as intersecting, coplanar overlap counts, and a triangle that has
/// collapsed to a segment or a point is treated as that segment or point.
///
/// Precondition: `a` and `b` are different poses (of the same model or of two); one pose given
/// twice aborts the program, in every build. Cost grows with the contact, not with the meshes: two
/// trees of boxes are descended together, and only where boxes meet are vertices posed and boxes
/// computed, each once until the next palette. Poses that are far apart cost O(J). That boxes wait
/// until they are asked for is Kavan & Zara 2005, section 4.2; tree and boxes are Pelt's own.
PELT_API QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                            const CollideOptions& options = {});

/// Whether any triangles of `a` and `b` intersect; as `collide`, stopping at the first contact.
PELT_API YesNo intersects(Pose& a, Pose& b, Scratch& scratch);

}  // namespace pelt
