#pragma once

/// How large a posed skin is, without posing it: for culling, shadows, levels of detail, exports.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/shapes.hpp>

#include <cstdint>
#include <limits>

namespace pelt {

/// Around the posed surface: all triangles. Vertices that no triangle uses do not count.
struct Bounds {
  Box box;
  Sphere sphere;  ///< its centre is the box's
};

struct BoundsOptions {
  /// So many levels of the tree are opened where the box can still shrink. 0: box and sphere come
  /// from the joint palette alone; beyond the depth of the tree the box is exact.
  std::uint32_t levels = 0;
};

/// Writes a box and a sphere that surely enclose the posed surface: every float32 posed vertex that
/// a triangle uses, rounding included. Frame of the joint palette.
///
/// O(J) with `levels` 0, and then nothing is posed and nothing opened: the box costs what
/// `set_palette` does, the sphere as much again and a half, and the box is a few hundredths to a
/// quarter larger than the exact one, for a human in motion. It is the hull of the joints' own rest
/// boxes, moved (Kavan & Zara 2005, eq. 2, with boxes and a body for each joint). Each level more
/// costs what opening a few nodes does; three leave less than a tenth.
PELT_API QueryStats bounds(Pose& pose, Bounds& result, const BoundsOptions& options = {});

/// The same with the exact box: bit for bit the smallest and largest coordinates of those posed
/// vertices that triangles use (see `posed_vertices`), but that zeros are positive. Opens the tree
/// only where the box can still grow. The sphere is one that surely encloses.
PELT_API QueryStats exact_bounds(Pose& pose, Bounds& result);

}  // namespace pelt
