/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "skin/palette_scan.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(scan_palette)

inline namespace PELT_INSTRUCTION_SET {

PaletteScan scan_palette(const float* floats, std::size_t joint_count) {
  return PELT_CHOOSE(scan_palette)(floats, joint_count);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
