#pragma once

/// Passes over all joints of a palette, in vector code.

#include "base/instruction_set.hpp"
#include "skin/dual_skin.hpp"

#include <cstddef>

namespace pelt::detail {

/// Result of one pass over joint matrices.
struct PaletteScan {
  float linear = 0, translation = 0;  ///< largest absolute elements
  bool is_affine = true;              ///< last rows are 0 0 0 1, and all elements are finite
};

inline namespace PELT_INSTRUCTION_SET {

/// `floats` has 16 elements for each joint.
PaletteScan scan_palette(const float* floats, std::size_t joint_count);

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Finds the rigid motions of finite affine matrices, 16 floats each. Computed in double and
/// rounded once. Returns false if one of them is not rigid (`find_not_rigid` tells why); `out` is
/// then meaningless.
bool find_rigid_motions(const float* matrices, std::size_t count, DualQuaternion* out);

/// Copies dual quaternions of eight floats each, normalised: the rotation gets length one,
/// and the part of the dual quaternion that belongs to no motion is removed. Computed in double and
/// rounded once. Returns false if one of them is not a unit dual quaternion
/// (`find_not_unit` tells why).
bool normalise_duals(const float* duals, std::size_t count, DualQuaternion* out);

/// The matrices of the motions, computed in double and rounded once. Returns the largest magnitude
/// of a coordinate of a translation; no other element is larger than one.
float find_matrices(const DualQuaternion* motions, std::size_t count, Matrix4* out);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
