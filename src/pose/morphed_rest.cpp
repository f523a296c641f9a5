#include "pose/morphed_rest.hpp"

#include "skin/skin.hpp"

namespace pelt::detail {
namespace {

void displace(const Tree& tree, const PoolTarget& run, float weight, std::vector<Vec3>& positions) {
  for (std::uint32_t i = 0; i < run.displacement_count; ++i) {
    const PlacedDisplacement& displacement = tree.morphs.displacements[run.first_displacement + i];
    Vec3& v = positions[displacement.place];
    v = displaced(v, weight, displacement.by);
  }
}

}  // namespace

MorphedRest::MorphedRest(const Tree& tree, const MorphWeights& morphs)
    : positions_(tree.rest_positions) {
  if (!morphs.any()) return;
  morphed_ = tree.rest_positions;
  for (const PoolTarget& run : tree.morphs.targets)
    if (const float weight = morphs[run.target]; weight != 0) displace(tree, run, weight, morphed_);
  positions_ = morphed_;
}

}  // namespace pelt::detail
