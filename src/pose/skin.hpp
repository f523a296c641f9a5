#pragma once

/// The definition of a posed vertex. Every query, baseline, export and test poses vertices by the
/// functions of this file, and "exact" means: exact on what they return.
///
/// Linear blend skinning (Kavan & Zara 2005, eq. 1), v' = sum_k w_k C_jk v, evaluated in float32
/// without fused operations, influences in ascending order of their joints:
///
///     B    = w_1 C_j1 + w_2 C_j2 + ...            entry by entry, summed from the left
///     v'_a = (B_a0 x + B_a2 z) + (B_a1 y + B_a3)  for a = x, y, z
///
/// A vertex with a single influence has weight 1 exactly, so B = C_j: the one-joint special case.

#include "base/float4.hpp"
#include "model/skinned_mesh.hpp"
#include "pose/palette.hpp"

#include <span>

namespace pelt::detail {

/// Lanes x, y, z of the posed vertex; lane 3 is meaningless.
inline Float4 posed_vertex4(const SkinnedMesh& mesh, const Palette& palette, std::uint32_t vertex) {
  const std::uint32_t begin = mesh.influence_begin[vertex];
  const std::uint32_t end = mesh.influence_begin[vertex + 1];
  const Influence* influence = mesh.influences.data() + begin;
  const float* m = palette[influence->joint].m.data();
  Float4 c0 = influence->weight * load4(m), c1 = influence->weight * load4(m + 4);
  Float4 c2 = influence->weight * load4(m + 8), c3 = influence->weight * load4(m + 12);
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    ++influence;
    m = palette[influence->joint].m.data();
    c0 = c0 + influence->weight * load4(m);
    c1 = c1 + influence->weight * load4(m + 4);
    c2 = c2 + influence->weight * load4(m + 8);
    c3 = c3 + influence->weight * load4(m + 12);
  }
  const Vec3& v = mesh.rest_positions[vertex];
  return (v.x * c0 + v.z * c2) + (v.y * c1 + c3);
}

inline Vec3 posed_vertex(const SkinnedMesh& mesh, const Palette& palette, std::uint32_t vertex) {
  const Float4 p = posed_vertex4(mesh, palette, vertex);
  return {p[0], p[1], p[2]};
}

/// Poses all vertices. Precondition: `out` has one element for each vertex.
void posed_vertices(const SkinnedMesh& mesh, const Palette& palette, std::span<Vec3> out);

}  // namespace pelt::detail

namespace pelt::scalar {

/// The definition above, spelled out float by float; the wide code must match its bits.
Vec3 posed_vertex(const detail::SkinnedMesh& mesh, const detail::Palette& palette,
                  std::uint32_t vertex);

}  // namespace pelt::scalar
