#pragma once

/// Definition of a posed vertex. Every query, comparison method, export and test poses vertices
/// with the functions of this file, and "exact" means exact on their results.
///
/// Linear blend skinning (Kavan & Zara 2005, eq. 1), v' = sum_k w_k C_jk v, evaluated in float32
/// without fused operations, influences in ascending order of their joints:
///
///     B    = w_1 C_j1 + w_2 C_j2 + ...            entry by entry, summed from the left
///     v'_a = (B_a0 x + B_a2 z) + (B_a1 y + B_a3)  for a = x, y, z
///
/// Morph targets come first: v = v0 + m_1 d_1 + m_2 d_2 ..., summed from the left, over the targets
/// that displace the vertex and whose weight is not zero, in ascending order.
///
/// Offsets come last. With the offset o and the cap c of the vertex,
///
///     v''_a = v'_a + min(max(o_a, -c), c)         for a = x, y, z
///
/// except that v''_a = v'_a if o_a is NaN or 0, or if c is 0. A posed vertex is therefore defined
/// for every offset, and offsets of 0 leave its bits as they are.
///
/// Models with dual quaternion skinning have another definition; see dual_skin.hpp.
///
/// A Float8 holds two columns of B, which is why x is paired with z and y with the translation. A
/// vertex with a single influence has weight 1 exactly, so B = C_j, the special case of one joint.

#include "base/float8.hpp"
#include "skin/dual_skin.hpp"
#include "skin/palette.hpp"
#include "skin/skinned_mesh.hpp"

#include <span>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns the posed vertex for `influence(0)` to `influence(count - 1)` in the lanes x, y, z. Lane
/// 3 is meaningless.
template <typename InfluenceAt>
inline Float4 posed_vertex4(const Vec3& rest, std::uint32_t count, const InfluenceAt& influence,
                            const Matrix4* palette) {
  const Influence first = influence(0);
  const float* m = palette[first.joint].m.data();
  Float8 xy = Float8(first.weight) * load8(m), zt = Float8(first.weight) * load8(m + 8);
  for (std::uint32_t i = 1; i < count; ++i) {
    const Influence next = influence(i);
    m = palette[next.joint].m.data();
    xy = xy + Float8(next.weight) * load8(m);
    zt = zt + Float8(next.weight) * load8(m + 8);
  }
  return fold(pair8(rest.x, rest.y) * xy + pair8(rest.z, 1) * zt);
}

/// Adds an offset to the posed vertex `v`, clamped to the cap along each axis.
inline Float4 offset_vertex4(const Float4& v, const Vec3& offset, float cap) {
  const Float4 o(offset.x, offset.y, offset.z, 0), zero(0.0f), most(cap);
  const Mask4 moves = (zero < abs(o)) & (zero < most);  // false for NaN
  return select(moves, v + max(min(o, most), zero - most), v);
}

/// Whether a coordinate of the offset is NaN or beyond the cap.
inline bool is_clamped(const Vec3& offset, float cap) {
  const auto is_within = [=](float o) { return -cap <= o && o <= cap; };
  return !(is_within(offset.x) && is_within(offset.y) && is_within(offset.z));
}

/// Returns `v`, displaced by one more target.
inline Vec3 displaced(const Vec3& v, float weight, const Vec3& by) {
  return {v.x + weight * by.x, v.y + weight * by.y, v.z + weight * by.z};
}

/// Returns the rest position with all displacements.
inline Vec3 morphed_vertex(const SkinnedMesh& mesh, const MorphWeights& morphs,
                           std::uint32_t vertex) {
  Vec3 v = mesh.rest_positions[vertex];
  if (!morphs.any()) return v;
  for (const Displacement& displacement : mesh.displacements_of(vertex))
    if (const float weight = morphs[displacement.target]; weight != 0)
      v = displaced(v, weight, displacement.by);
  return v;
}

inline Float4 posed_vertex4(const SkinnedMesh& mesh, const Palette& palette, std::uint32_t vertex) {
  const Influence* influences = &mesh.influences[mesh.influence_begin[vertex]];
  const std::uint32_t count = mesh.influence_begin[vertex + 1] - mesh.influence_begin[vertex];
  const auto at = [=](std::uint32_t i) { return influences[i]; };
  const Vec3 rest = morphed_vertex(mesh, palette.morphs(), vertex);
  const Float4 posed = palette.is_dual()
                           ? dual_posed_vertex4(rest, count, at, palette.duals().data())
                           : posed_vertex4(rest, count, at, palette.joints().data());
  if (palette.offsets().empty()) return posed;
  return offset_vertex4(posed, palette.offsets()[vertex], mesh.offset_caps[vertex]);
}

inline Vec3 posed_vertex(const SkinnedMesh& mesh, const Palette& palette, std::uint32_t vertex) {
  const Float4 p = posed_vertex4(mesh, palette, vertex);
  return {p[0], p[1], p[2]};
}

}  // namespace PELT_INSTRUCTION_SET

/// Poses all vertices. Precondition: `out` has one element for each vertex.
void posed_vertices(const SkinnedMesh& mesh, const Palette& palette, std::span<Vec3> out);

}  // namespace pelt::detail

namespace pelt::scalar {

/// The definition above, written float by float. The vector code must produce the same bits.
Vec3 posed_vertex(const detail::SkinnedMesh& mesh, const detail::Palette& palette,
                  std::uint32_t vertex);

}  // namespace pelt::scalar
