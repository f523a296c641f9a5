#pragma once

#include "model/tree.hpp"
#include "skin/skin.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Plain pointers to the arrays of the tree's vertices; otherwise the compiler reloads the vectors'
/// data pointers after every store.
struct VertexArrays {
  explicit VertexArrays(const Tree& tree)
      : influence_begin(tree.influence_begin.data()),
        joints(tree.joints.data()),
        weights(tree.weights.data()) {}

  std::uint32_t influence_count(std::size_t place) const {
    return influence_begin[place + 1] - influence_begin[place];
  }

  /// Returns the influences of the vertex at `place` as a function of their number.
  [[gnu::always_inline]] auto influences(std::size_t place) const {
    const std::uint16_t* joint = joints + influence_begin[place];
    const float* weight = weights + influence_begin[place];
    return [=](std::uint32_t i) { return Influence{joint[i], weight[i]}; };
  }

  /// Poses the vertex at `place` with `count` influences and the rest position `rest`.
  [[gnu::always_inline]] Float4 pose(const Vec3& rest, std::uint32_t place, std::uint32_t count,
                                     const Matrix4* palette) const {
    return posed_vertex4(rest, count, influences(place), palette);
  }

  Float4 pose(const Vec3& rest, std::uint32_t place, const Palette& palette) const {
    const std::uint32_t count = influence_count(place);
    return palette.is_dual()
               ? dual_posed_vertex4(rest, count, influences(place), palette.duals().data())
               : pose(rest, place, count, palette.joints().data());
  }

  const std::uint32_t* influence_begin;
  const std::uint16_t* joints;
  const float* weights;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
