#include "skin/skin.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {

void posed_vertices(const SkinnedMesh& mesh, const Palette& palette, std::span<Vec3> out) {
  PELT_ASSERT(out.size() == mesh.rest_positions.size());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) out[v] = posed_vertex(mesh, palette, v);
}

}  // namespace pelt::detail

namespace pelt::scalar {
namespace {

float offset_coordinate(float v, float offset, float cap) {
  const bool moves = std::fabs(offset) > 0 && cap > 0;  // false for NaN
  return moves ? v + std::clamp(offset, -cap, cap) : v;
}

Vec3 offset_vertex(const Vec3& v, const Vec3& offset, float cap) {
  return {offset_coordinate(v.x, offset.x, cap), offset_coordinate(v.y, offset.y, cap),
          offset_coordinate(v.z, offset.z, cap)};
}

}  // namespace

Vec3 posed_vertex(const detail::SkinnedMesh& mesh, const detail::Palette& palette,
                  std::uint32_t vertex) {
  const auto influences = mesh.influences_of(vertex);
  float blended[16];
  for (int e = 0; e < 16; ++e) {
    blended[e] = influences[0].weight * palette[influences[0].joint].m[e];
    for (std::size_t k = 1; k < influences.size(); ++k)
      blended[e] += influences[k].weight * palette[influences[k].joint].m[e];
  }
  const Vec3& rest = mesh.rest_positions[vertex];
  float v[3] = {rest.x, rest.y, rest.z};
  const detail::MorphWeights& morphs = palette.morphs();
  for (const detail::Displacement& displacement : mesh.displacements_of(vertex)) {
    const float weight = morphs.any() ? morphs[displacement.target] : 0;
    if (weight == 0) continue;
    v[0] += weight * displacement.by.x;
    v[1] += weight * displacement.by.y;
    v[2] += weight * displacement.by.z;
  }
  const auto coordinate = [&](int a) {
    return (blended[a] * v[0] + blended[8 + a] * v[2]) + (blended[4 + a] * v[1] + blended[12 + a]);
  };
  const Vec3 posed = {coordinate(0), coordinate(1), coordinate(2)};
  if (palette.offsets().empty()) return posed;
  return offset_vertex(posed, palette.offsets()[vertex], mesh.offset_caps[vertex]);
}

}  // namespace pelt::scalar
