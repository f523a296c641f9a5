#pragma once

#include "skin/dual_quaternion.hpp"

#include <cstdint>
#include <utility>

namespace pelt::detail {

/// Two joints that share a vertex of the mesh, with dual quaternion skinning.
struct JointLink {
  std::uint16_t first = 0, second = 0;           ///< joints, ascending
  float centre[4] = {0, 0, 0, 1}, half[4] = {};  ///< box of the rest positions that follow both
};

/// The order of links.
inline std::pair<std::uint16_t, std::uint16_t> joints_of(const JointLink& link) {
  return {link.first, link.second};
}

/// The motion of the two joints of a link in a palette. Vectors are in the frame of the palette.
/// model/dual_bounds.hpp has the symbols and the rounding.
struct LinkMotion {
  float low[4] = {},
        high[4] = {};  ///< bounds of (p_j - p_k) x u_jk in the link's box; high[3]: s_jk^2
  float swell[4] = {0, 0, 0, 1};  ///< bound of s_jk |p_j - p_k| in the link's box; swell[3]: |D_jk|
  float turn[4] = {0, 0, 0,
                   1};  ///< u_jk, with the sign that makes D_jk positive; turn[3]: D_jk, signed
};

/// Rounding of a product of two unit quaternions.
inline constexpr float kCosineRounding = 0x1p-20f;

/// A joint of a palette.
struct MovedJoint {
  const DualQuaternion& dual;
  const Matrix4& matrix;
};

/// `growth` is how far morph targets displace a rest position, and `slack` the rounding of the
/// differences of images.
LinkMotion motion_of(const JointLink& link, const MovedJoint& first, const MovedJoint& second,
                     float growth, float slack);

}  // namespace pelt::detail
