#pragma once

/// Plain shapes, in the frame of the joint palette like everything that queries see.

#include <pelt/math.hpp>

namespace pelt {

/// Axis-aligned and closed: all points with low <= p <= high on each axis.
struct Box {
  Vec3 low, high;
};

/// Closed: all points no further than `radius` from `centre`.
struct Sphere {
  Vec3 centre;
  float radius = 0;
};

}  // namespace pelt
