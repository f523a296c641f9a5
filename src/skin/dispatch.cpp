/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "skin/palette_scan.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(scan_palette)

inline namespace PELT_TARGET {

PaletteScan scan_palette(const float* floats, std::size_t joint_count) {
  return PELT_CHOOSE(scan_palette)(floats, joint_count);
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
