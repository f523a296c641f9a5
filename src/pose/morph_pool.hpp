#pragma once

#include "model/tree.hpp"
#include "skin/skin.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns the number of displacements by active morph targets in a node's pool.
inline std::uint64_t displacement_count(const Tree& tree, std::uint32_t index,
                                        const MorphWeights& morphs) {
  const PoolTarget* targets = tree.morphs.targets.data();
  const std::uint32_t* begin = tree.morphs.node_begin.data() + index;
  std::uint64_t count = 0;
  each_active(targets + begin[0], targets + begin[1], morphs,
              [&](const PoolTarget& target) { count += target.displacement_count; });
  return count;
}

/// Writes the rest positions of a node's pool, displaced by the active morph targets, to `out` in
/// the layout of posed vertices. Returns the number of displacements; if it is 0, writes nothing.
inline std::uint64_t morph_pool(const Tree& tree, std::uint32_t index, const MorphWeights& morphs,
                                float* out) {
  const Node& node = tree.nodes[index];
  const PoolTarget* targets = tree.morphs.targets.data();
  const std::uint32_t* begin = tree.morphs.node_begin.data() + index;
  std::uint64_t displaced_count = 0;
  each_active(targets + begin[0], targets + begin[1], morphs, [&](const PoolTarget& target) {
    if (displaced_count == 0)
      for (std::uint32_t v = 0; v < node.vertex_count; ++v) {
        const Vec3& rest = tree.rest_positions[node.first_vertex + v];
        float* to = out + std::size_t{kFloatsPerVertex} * v;
        to[0] = rest.x, to[1] = rest.y, to[2] = rest.z;
      }
    const PlacedDisplacement* displacement =
        tree.morphs.displacements.data() + target.first_displacement;
    for (std::uint32_t i = 0; i < target.displacement_count; ++i, ++displacement) {
      float* at = out + std::size_t{kFloatsPerVertex} * (displacement->place - node.first_vertex);
      const Vec3 v = displaced({at[0], at[1], at[2]}, morphs[target.target], displacement->by);
      at[0] = v.x, at[1] = v.y, at[2] = v.z;
    }
    displaced_count += target.displacement_count;
  });
  return displaced_count;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
