#pragma once

/// Intersections of pairs of triangles.

#include "contact/triangle_crossing.hpp"
#include "geometry/triangle_pair.hpp"
#include "model/surface.hpp"

#include <array>
#include <cstdint>

namespace pelt::detail {

/// The surfaces of the two triangles of each contact.
struct ContactSurfaces {
  const Surface &a, &b;
  bool is_self = false;  ///< contacts of a pose with itself
};

/// Identifies a corner, an edge or a face by three numbers, of which the last is the kind.
using FeatureName = std::array<std::uint32_t, 3>;

/// The features that meet at an end of a trace. Equal for all contacts that share these features.
struct EndKey {
  FeatureName first{}, second{};

  /// Whether `first` is the feature of `b`. Only in contacts of a pose with itself: either triangle
  /// of a contact may have the lower number, so the feature with the lower name is first.
  bool is_swapped = false;
};

EndKey key_of(const CrossingEnd& end, const Contact& contact, const ContactSurfaces& surfaces);

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
