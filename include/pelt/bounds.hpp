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
  /// Number of tree levels to open. Nodes that cannot extend the box found so far are skipped. With
  /// 0, box and sphere are computed from the joint palette alone. The box is exact if `levels` is
  /// at least the depth of the tree.
  std::uint32_t levels = 0;
};

/// Writes a box and a sphere that are guaranteed to enclose the posed surface, in the frame of the
/// joint palette. The guarantee includes rounding: both contain the float32 posed vertices (see
/// `posed_vertices`) of all triangles.
///
/// Cost: O(J) with `levels` 0, without posing or opening anything. Box and sphere together then
/// cost about two and a half times as much as `set_palette`. Each additional level opens a few more
/// nodes. Allocates only in the pose, for nodes that are opened.
///
/// Accuracy: for a human in motion, the box with `levels` 0 is a few per cent to 25 % larger than
/// the exact box. With `levels` 3, it is less than 10 % larger.
///
/// Source: with `levels` 0, each joint has a box around the rest positions that it moves. The joint
/// palette transforms these boxes, and the result encloses all of them. (This is eq. 2 of Kavan &
/// Zara 2005, applied to one box per joint.) If each joint's weight is nearly an affine function of
/// the rest position, for example because there is only one joint, `bounds` may compute a tighter
/// box in another way.
PELT_API QueryStats bounds(Pose& pose, Bounds& result, const BoundsOptions& options = {});

/// Writes the exact box: bit for bit the smallest and largest coordinates of the posed vertices
/// that triangles use (see `posed_vertices`), except that -0 becomes +0. The sphere is guaranteed
/// to enclose the surface.
///
/// Cost: opens only nodes that may reach beyond the box found so far. Allocates only in the pose,
/// for nodes that are opened.
PELT_API QueryStats exact_bounds(Pose& pose, Bounds& result);

}  // namespace pelt
