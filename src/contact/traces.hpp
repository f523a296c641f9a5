#pragma once

/// Intersections of pairs of triangles.

#include "contact/end_key.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>

namespace pelt::detail {

/// The triangles of a contact.
struct ContactCorners {
  TriangleCorners a, b;
};

/// Describes the intersection of a contact's triangles. Also writes the keys of its ends, if it is
/// a segment or a point.
ContactTrace trace_of(const Contact& contact, const ContactCorners& corners,
                      const ContactSurfaces& surfaces, std::array<EndKey, 2>& ends);

/// The length of the segment of a trace.
double length_of(const ContactTrace& trace);

}  // namespace pelt::detail
