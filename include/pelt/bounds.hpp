#pragma once

/// Boxes and spheres around a posed skin, mostly without posing vertices. For culling, shadows,
/// levels of detail and exports.

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
  Sphere sphere;  ///< has the same centre as `box`
};

struct BoundsOptions {
  /// Number of tree levels to open. With 0, box and sphere are computed from the joint palette
  /// and the morph weights, without posing vertices. The box is exact if `levels` is at least the
  /// depth of the tree. Nodes that cannot extend the box found so far are not opened.
  std::uint32_t levels = 0;
};

/// Writes a box and a sphere in the frame of the joint palette. Both are guaranteed to enclose the
/// posed surface. The guarantee includes rounding: box and sphere contain the float32 posed
/// vertices (see `posed_vertices`) of all triangles.
///
/// Cost: O(J) with `levels` 0, about two and a half times as much as `set_palette`. Each morph
/// weight other than 0 adds at most O(J). With `levels` 0, no node is opened. Each additional level
/// opens a few more nodes. Allocates only in the pose, for nodes that are opened.
///
/// Accuracy: for a human in motion, the box with `levels` 0 is a few per cent to 25 % larger than
/// the exact box. With `levels` 3, it is less than 10 % larger.
///
/// Source: with `levels` 0, eq. 2 of Kavan & Zara 2005, applied to one box per joint. For each
/// joint, the model stores a box around the rest positions that the joint moves. The joint palette
/// transforms these boxes, and the result encloses all of them. If the weights of each joint are
/// nearly an affine function of the rest position, `bounds` may compute a tighter box in another
/// way.
PELT_API QueryStats bounds(Pose& pose, Bounds& result, const BoundsOptions& options = {});

/// Writes the exact box of the posed surface, and a sphere that is guaranteed to enclose the posed
/// surface. The box has the smallest and largest coordinates of all posed vertices of triangles
/// (see `posed_vertices`), bit for bit, except that -0 becomes +0.
///
/// Cost: opens only nodes that may reach beyond the box found so far. Allocates only in the pose,
/// for nodes that are opened.
PELT_API QueryStats exact_bounds(Pose& pose, Bounds& result);

}  // namespace pelt
