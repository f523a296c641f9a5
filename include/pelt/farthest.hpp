#pragma once

/// The point of a posed skin that is farthest in a direction: the support point of the skin.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/math.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <cstdint>

namespace pelt {

/// Result of `farthest_vertex`. Identifies the vertex by a triangle and one of its corners.
struct FarthestVertex {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::uint32_t triangle = kNone;  ///< index into the model's triangle array
  std::uint32_t corner = 0;        ///< 0, 1 or 2: which corner of that triangle
  Vec3 position;                   ///< posed

  /// Whether a query has written this result.
  explicit operator bool() const { return triangle != kNone; }
};

/// Writes the posed vertex p with the greatest dot(direction, p), among all vertices that triangles
/// use. Dot products are compared exactly. If several corners of triangles have the greatest dot
/// product, writes the lowest corner of the lowest of these triangles.
///
/// `direction`: in the frame of the joint palette, of any length.
///
/// Precondition: `direction` is finite and not zero. Otherwise the program aborts, in every build.
///
/// Cost: opens only nodes whose boxes reach beyond the farthest vertex so far. In each node, the
/// box that reaches farthest is visited first. The query often opens only one node per level of the
/// tree. Allocates only in the pose, for nodes that are opened.
PELT_API QueryStats farthest_vertex(Pose& pose, const Vec3& direction, FarthestVertex& result);

}  // namespace pelt
