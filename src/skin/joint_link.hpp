#pragma once

/// Joints that share vertices, and their relative motion in a palette.

#include "base/instruction_set.hpp"
#include "skin/dual_skin.hpp"

#include <cstdint>
#include <span>
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
/// model/node_bounds.hpp has the symbols and the rounding.
struct LinkMotion {
  /// (p_j - p_k) x u_jk in the link's box is between minus the first half and the second half; the
  /// last element is s_jk^2.
  float down_up[8] = {};
  float swell[4] = {0, 0, 0, 1};  ///< bound of s_jk |p_j - p_k| in the link's box; swell[3]: |D_jk|
  float turn[4] = {0, 0, 0,
                   1};  ///< u_jk, with the sign that makes D_jk positive; turn[3]: D_jk, signed
};

/// The largest elements of the motions of all links, at least zero.
struct LinkHull {
  float down_up[8] = {};
  float swell[4] = {};
  float least_cosine = 1;  ///< of the signed D_jk
};

/// Rounding of a product of two unit quaternions.
inline constexpr float kCosineRounding = 0x1p-20f;

/// The joints of a palette, as dual quaternions and as matrices.
struct MovedJoints {
  const DualQuaternion* duals;
  const Matrix4* matrices;
};

inline namespace PELT_INSTRUCTION_SET {

/// Computes the motion of each link. `growth` is how far morph targets displace a rest position,
/// and `slack` the rounding of the differences of images.
LinkHull move_links(std::span<const JointLink> links, const MovedJoints& joints, float growth,
                    float slack, LinkMotion* out);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
