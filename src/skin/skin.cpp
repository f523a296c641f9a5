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

/// The rest position with all displacements.
void morph(const detail::SkinnedMesh& mesh, const detail::MorphWeights& morphs,
           std::uint32_t vertex, float (&v)[3]) {
  const Vec3& rest = mesh.rest_positions[vertex];
  v[0] = rest.x, v[1] = rest.y, v[2] = rest.z;
  for (const detail::Displacement& displacement : mesh.displacements_of(vertex)) {
    const float weight = morphs.any() ? morphs[displacement.target] : 0;
    if (weight == 0) continue;
    v[0] += weight * displacement.by.x;
    v[1] += weight * displacement.by.y;
    v[2] += weight * displacement.by.z;
  }
}

Vec3 linear_vertex(std::span<const detail::Influence> influences, const detail::Palette& palette,
                   const float (&v)[3]) {
  float blended[16];
  for (int e = 0; e < 16; ++e) {
    blended[e] = influences[0].weight * palette[influences[0].joint].m[e];
    for (std::size_t k = 1; k < influences.size(); ++k)
      blended[e] += influences[k].weight * palette[influences[k].joint].m[e];
  }
  const auto coordinate = [&](int a) {
    return (blended[a] * v[0] + blended[8 + a] * v[2]) + (blended[4 + a] * v[1] + blended[12 + a]);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

float dot(const float* a, const float* b) {
  return (a[0] * b[0] + a[2] * b[2]) + (a[1] * b[1] + a[3] * b[3]);
}

/// Element `axis` of a cross product.
float cross(const float* a, const float* b, int axis) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  return a[next] * b[last] - a[last] * b[next];
}

Vec3 dual_vertex(std::span<const detail::Influence> influences, const detail::Palette& palette,
                 const float (&v)[3]) {
  const float* pivot = palette.duals()[influences[0].joint].real;
  float q[4] = {}, e[4] = {};
  for (const detail::Influence& influence : influences) {
    const detail::DualQuaternion& dual = palette.duals()[influence.joint];
    const float sign = dot(pivot, dual.real) < 0 ? -1.0f : 1.0f;
    for (int i = 0; i < 4; ++i) {
      q[i] += sign * influence.weight * dual.real[i];
      e[i] += sign * influence.weight * dual.dual[i];
    }
  }
  const float scale = 2 / dot(q, q);
  float c[3], posed[3];
  for (int a = 0; a < 3; ++a) c[a] = cross(q, v, a) + q[3] * v[a];
  for (int a = 0; a < 3; ++a) {
    const float shift = (q[3] * e[a] - e[3] * q[a]) + cross(q, e, a);
    posed[a] = v[a] + scale * (cross(q, c, a) + shift);
  }
  return {posed[0], posed[1], posed[2]};
}

}  // namespace

Vec3 posed_vertex(const detail::SkinnedMesh& mesh, const detail::Palette& palette,
                  std::uint32_t vertex) {
  float v[3];
  morph(mesh, palette.morphs(), vertex, v);
  const auto influences = mesh.influences_of(vertex);
  const Vec3 posed = palette.is_dual() ? dual_vertex(influences, palette, v)
                                       : linear_vertex(influences, palette, v);
  if (palette.offsets().empty()) return posed;
  return offset_vertex(posed, palette.offsets()[vertex], mesh.offset_caps[vertex]);
}

}  // namespace pelt::scalar
