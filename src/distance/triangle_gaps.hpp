#pragma once

/// Distances of the triangles of two clusters: lower bounds along a direction, and those of eight
/// pairs at once.

#include <pelt/math.hpp>

#include "base/vec3.hpp"
#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "query/slots.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// One value for each triangle of a cluster.
struct alignas(32) TriangleValues {
  float of[kMaxClusterTriangles];
};

/// Positions of triangles along a direction of length one, up to rounding of float.
class Along {
 public:
  /// Computes positions relative to `origin`, so that the position of the world's origin costs no
  /// precision.
  Along(const Vec3& direction, const Vec3& origin) : direction_(direction), origin_(origin) {}

  /// Returns the least (or largest) position of each triangle's corners. Lanes beyond the last
  /// triangle repeat it.
  TriangleValues lowest(const PosedCluster& cluster) const;
  TriangleValues highest(const PosedCluster& cluster) const;

 private:
  Vec3 direction_, origin_;
};

/// Returns the triangle with the least (or largest) value.
std::uint32_t lowest_of(const TriangleValues& values);
std::uint32_t highest_of(const TriangleValues& values);

/// Returns the triangles with values of at most `most`, one bit each.
unsigned up_to(const TriangleValues& values, float most);

/// Returns the corners of a triangle of the cluster; `place` is an index into Tree::corners.
TriangleCorners corners_of(const PosedCluster& cluster, std::uint32_t place);

/// Error of gaps along a direction, between points of two clusters.
///
/// Rounding. With e = 2^-24 and M the largest coordinate relative to the origin, the position of a
/// point is a sum of three products with at most six relative errors e, and the direction is longer
/// than one by less than 4 e. Together, the error is less than 20 e M, and that of a difference of
/// two positions less than 44 e M.
float gap_error(const PosedCluster& a, const PosedCluster& b, const Vec3& origin);

/// Returns the low corner of the cluster's box.
Vec3 low_corner(const PosedCluster& cluster);

/// Normalises a vector; zero stays zero.
Vec3 direction_of(const Vec3d& way);

/// Returns the unit direction from the middle of the box of `a` to that of `b`; 0 if they coincide.
Vec3 direction_between(const PosedCluster& a, const PosedCluster& b);

/// Writes the squared distances of the first `count` of eight pairs, with the same bits as
/// `closest_points` (triangle_distance.hpp), at a fifth of its cost. Precondition: the pairs do not
/// touch.
void squared_distances(const TrianglePairs8& pairs, std::uint32_t count, double (&squared)[8]);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
