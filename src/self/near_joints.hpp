#pragma once

/// Finds the joints of a character that are neighbours, and the zones in which its skin creases.

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/self_filter.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// A vertex where triangles of a body share a corner with triangles of a body above it.
struct BorderVertex {
  std::uint16_t body = 0;
  std::uint32_t vertex = 0;

  friend auto operator<=>(const BorderVertex&, const BorderVertex&) = default;
};

/// Where one skin covers several bodies of a character.
struct Borders {
  std::vector<IndexPair> pairs;        ///< ascending: a body and one above it that share a corner
  std::vector<BorderVertex> vertices;  ///< ascending; at least one of each first body of `pairs`
};

/// The zones of a character's joints. Each is named by the body below the joint.
struct JointZones {
  std::vector<TriangleZone> triangles;
  std::size_t pair_count = 0;  ///< number of first elements of `Borders::pairs` that have zones
};

/// Returns the zones in which skin may crease. In the pose of `positions`, the zone of a body
/// is a ball around the border with the bodies above it: the ball's centre is the centre of the
/// border vertices' bounding box, and its radius is 2.5 times the distance of the farthest border
/// vertex from the centre. If the body is thicker than the border, its thickness is used instead of
/// this distance: the root mean square distance of its triangle corners from the line through the
/// centre and their mean. The zone contains the triangles of the body and of those that adjoin it
/// above, if they have a corner in the ball.
///
/// A joint that is bent by 133 degrees brings two cylinders of equal thickness together up to this
/// distance. A turn of the joint does not change distances from it, so that any pose would give
/// nearly the same zones.
///
/// `positions`: [V] posed vertices.
/// `triangle_bodies`: [T] the body of each triangle.
///
/// Cost: O(V + T). Pairs that would cost more get no zones.
JointZones joint_zones(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                       std::span<const std::uint16_t> triangle_bodies, const Borders& borders);

/// A surface that joints move, with valid indices.
struct JointedSurface {
  std::span<const Vec3> rest_positions;        // [V]
  std::span<const Vec3> positions;             // [V] in a pose, for the sizes of zones
  std::span<const Triangle> triangles;         // [T]
  std::span<const std::uint16_t> main_joints;  // [T]
};

/// Returns which joints are neighbours, see pelt::near_joints. Preconditions: its errors.
NearJoints near_joints(const JointedSurface& surface, const JointBodies& bodies,
                       std::span<const Contact> at_rest);

}  // namespace pelt::detail
