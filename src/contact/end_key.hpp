#pragma once

#include "contact/triangle_crossing.hpp"
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

}  // namespace pelt::detail
