#pragma once

/// Intersections of pairs of triangles.

#include "geometry/triangle_crossing.hpp"
#include "model/surface.hpp"

namespace pelt::detail {

/// The triangles of a contact.
struct ContactCorners {
  TriangleCorners a, b;
};

/// Writes the crossing of a contact's triangles, and returns it as `ContactTrace` has it.
ContactTrace trace_of(const Contact& contact, const ContactCorners& corners, const Surface& a,
                      const Surface& b, Crossing& crossing);

}  // namespace pelt::detail
