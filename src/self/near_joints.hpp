#pragma once

#include <pelt/self_filter.hpp>

#include <cstdint>
#include <span>

namespace pelt::detail {

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
