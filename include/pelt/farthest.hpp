#pragma once

/// The point of a posed skin that is farthest in a direction, also called its support point.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/math.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <cstdint>

namespace pelt {

/// A vertex, as a corner of a triangle.
struct FarthestVertex {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::uint32_t triangle = kNone;  ///< the caller's number; the lowest of those with the vertex
  std::uint32_t corner = 0;        ///< 0, 1 or 2, in the caller's order
  Vec3 position;                   ///< posed

  explicit operator bool() const { return triangle != kNone; }
};

/// Finds the vertex p of `pose` with the greatest dot(direction, p), which is compared exactly,
/// among the vertices of triangles. Of equally far vertices it returns the one with the lowest
/// triangle and then the lowest corner.
///
/// `direction` need not have length 1. Precondition: it is finite and not zero.
///
/// Cost: opens the nodes whose boxes reach beyond the farthest vertex so far, best box first; often
/// one node for each level of the tree. Allocation: memory of the pose only.
PELT_API QueryStats farthest_vertex(Pose& pose, const Vec3& direction, FarthestVertex& result);

}  // namespace pelt
