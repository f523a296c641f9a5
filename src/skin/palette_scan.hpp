#pragma once

#include "base/instruction_set.hpp"

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
