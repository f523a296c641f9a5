#pragma once

#include "base/target.hpp"

#include <cstddef>

namespace pelt::detail {

/// What one pass over joint matrices finds.
struct PaletteScan {
  float linear = 0, translation = 0;  ///< largest elements
  bool is_affine = true;              ///< last rows are 0 0 0 1, and all elements are finite
};

inline namespace PELT_TARGET {

/// `floats` has 16 for each joint.
PaletteScan scan_palette(const float* floats, std::size_t joint_count);

}  // namespace PELT_TARGET
}  // namespace pelt::detail
