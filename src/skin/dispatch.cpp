/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "skin/joint_link.hpp"
#include "skin/palette_lanes.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(scan_palette)
PELT_DECLARE_VERSIONS(find_rigid_motions)
PELT_DECLARE_VERSIONS(normalise_duals)
PELT_DECLARE_VERSIONS(find_matrices)
PELT_DECLARE_VERSIONS(move_links)

inline namespace PELT_INSTRUCTION_SET {

PaletteScan scan_palette(const float* floats, std::size_t joint_count) {
  return PELT_CHOOSE(scan_palette)(floats, joint_count);
}

bool find_rigid_motions(const float* matrices, std::size_t count, DualQuaternion* out) {
  return PELT_CHOOSE(find_rigid_motions)(matrices, count, out);
}

bool normalise_duals(const float* duals, std::size_t count, DualQuaternion* out) {
  return PELT_CHOOSE(normalise_duals)(duals, count, out);
}

float find_matrices(const DualQuaternion* motions, std::size_t count, Matrix4* out) {
  return PELT_CHOOSE(find_matrices)(motions, count, out);
}

LinkHull move_links(std::span<const JointLink> links, const MovedJoints& joints, float growth,
                    float slack, LinkMotion* out) {
  return PELT_CHOOSE(move_links)(links, joints, growth, slack, out);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
