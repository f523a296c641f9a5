#pragma once

/// Poses a pool of a model with dual quaternion skinning, eight vertices at a time.

#include "geometry/points8.hpp"
#include "model/tree.hpp"
#include "skin/dual_skin.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The sum of the weighted dual quaternions of a vertex: the real part in the low half, the dual
/// part in the high half. `kMayNegate`: some dual quaternions may count negated.
template <bool kMayNegate>
inline Float8 blend(const Tree& tree, std::uint32_t place, const DualQuaternion* palette) {
  const std::uint16_t* joint = tree.joints.data() + tree.influence_begin[place];
  const std::uint16_t* const end = tree.joints.data() + tree.influence_begin[place + 1];
  const float* weight = tree.weights.data() + tree.influence_begin[place];
  const DualQuaternion& pivot = palette[*joint];
  const auto weighted = [](float factor, const DualQuaternion& dual) {
    return Float8(factor) * Float8(load4(dual.real), load4(dual.dual));
  };
  Float8 sum = Float8(0.0f) + weighted(*weight, pivot);
  while (++weight, ++joint != end) {
    const DualQuaternion& dual = palette[*joint];
    const bool is_negated = kMayNegate && dot(dual_of(pivot), dual_of(dual)) < 0;
    sum = sum + weighted(is_negated ? -*weight : *weight, dual);
  }
  return sum;
}

/// The sums of eight vertices, one in each lane.
inline Dual<Float8> transposed(const Float8 (&b)[8]) {
  const Rows8 r = rows8(b[0].low(), b[1].low(), b[2].low(), b[3].low(), b[4].low(), b[5].low(),
                        b[6].low(), b[7].low());
  const Rows8 e = rows8(b[0].high(), b[1].high(), b[2].high(), b[3].high(), b[4].high(),
                        b[5].high(), b[6].high(), b[7].high());
  return {r.x, r.y, r.z, r.w, e.x, e.y, e.z, e.w};
}

/// Poses up to eight vertices.
template <bool kMayNegate, typename RestAt>
void pose_dual_vertices(const Tree& tree, const RestAt& rest_at, const DualQuaternion* palette,
                        std::uint32_t place, std::uint32_t count, float* out) {
  Float8 blends[8];
  Float4 points[8];
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 v = rest_at(place + i, out + std::size_t{kFloatsPerVertex} * i);
    points[i] = Float4(v.x, v.y, v.z, 0);
    blends[i] = blend<kMayNegate>(tree, place + i, palette);
  }
  for (std::uint32_t i = count; i < 8; ++i) points[i] = points[0], blends[i] = blends[0];
  Points8 p = transpose8(points[0], points[1], points[2], points[3], points[4], points[5],
                         points[6], points[7]);
  move_point(transposed(blends), p.x, p.y, p.z);
  points_of(p, points);
  for (std::uint32_t i = 0; i < count; ++i)
    store4(out + std::size_t{kFloatsPerVertex} * i, points[i]);
}

template <bool kMayNegate, typename RestAt>
void pose_dual_run(const Tree& tree, const RestAt& rest_at, const DualQuaternion* palette,
                   std::uint32_t place, std::uint32_t end, float* out) {
  for (; place + 8 <= end; place += 8, out += std::size_t{8} * kFloatsPerVertex)
    pose_dual_vertices<kMayNegate>(tree, rest_at, palette, place, 8, out);
  if (place < end) pose_dual_vertices<kMayNegate>(tree, rest_at, palette, place, end - place, out);
}

/// `rest_at(place, out)` returns the rest position of a vertex, where `out` is the destination of
/// the posed vertex.
template <typename RestAt>
void pose_dual_pool(const Tree& tree, const RestAt& rest_at, const Palette& palette,
                    std::uint32_t place, std::uint32_t end, float* out) {
  const DualQuaternion* const duals = palette.duals().data();
  if (palette.negates_none())
    pose_dual_run<false>(tree, rest_at, duals, place, end, out);
  else
    pose_dual_run<true>(tree, rest_at, duals, place, end, out);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
