#pragma once

/// Boxes and spheres around a posed skin without posing it: for culling, shadows, levels of detail
/// and exports.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/shapes.hpp>

#include <cstdint>
#include <limits>

namespace pelt {

/// Bounds of the posed surface, that is, of all triangles. Vertices without triangles do not count.
struct Bounds {
  Box box;
  Sphere sphere;  ///< has the centre of the box
};

struct BoundsOptions {
  /// Number of tree levels to open, except for nodes within the box found so far. With 0, box and
  /// sphere come from the joint palette alone. The box is exact if `levels` is at least the depth
  /// of the tree.
  std::uint32_t levels = 0;
};

/// Writes a box and a sphere that are guaranteed to enclose the posed surface, in the frame of the
/// joint palette. The guarantee includes rounding: both contain the float32 posed vertices (see
/// `posed_vertices`) of all triangles.
///
/// Cost: O(J) with `levels` 0, without posing or opening anything. The box then costs about as much
/// as `set_palette`, and the sphere one and a half times that. Each additional level costs the
/// opening of a few nodes.
///
/// Accuracy: for a human in motion, the box of `levels` 0 is a few per cent to 25 % larger than the
/// exact one; three levels leave less than 10 %. The box of `levels` 0 encloses a posed box per
/// joint. Before posing, this box encloses the rest positions that the joint moves. (This is eq. 2
/// of Kavan & Zara 2005, with boxes, and with one body per joint.)
PELT_API QueryStats bounds(Pose& pose, Bounds& result, const BoundsOptions& options = {});

/// Writes the exact box: bit for bit the smallest and largest coordinates of the posed vertices
/// that triangles use (see `posed_vertices`), except that zeros are positive. The sphere is
/// guaranteed to enclose the surface.
///
/// Cost: opens only nodes that may reach beyond the box found so far.
PELT_API QueryStats exact_bounds(Pose& pose, Bounds& result);

}  // namespace pelt
