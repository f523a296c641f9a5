#include "asset/assemble.hpp"

#include "asset/affine.hpp"

#include <optional>

namespace pelt::asset {

namespace {

/// Returns for each vertex whether it belongs to a part whose `skinned` has this value.
std::vector<bool> vertices_of_parts(const Asset& asset, bool skinned) {
  std::vector<bool> belongs(asset.rest_positions.size(), false);
  for (const Part& part : asset.parts) {
    if (part.skinned != skinned) continue;
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      for (const std::uint32_t v : asset.triangles[part.first_triangle + t]) belongs[v] = true;
    }
  }
  return belongs;
}

/// Returns for each joint whether any of these vertices follows it.
std::vector<bool> joints_of(const Asset& asset, const std::vector<bool>& vertices) {
  std::vector<bool> named(asset.joints.size(), false);
  for (std::size_t i = 0; i < asset.joint_indices.size(); ++i) {
    const bool counts = vertices[i / asset.influences_per_vertex] && asset.weights[i] > 0;
    if (counts) named[asset.joint_indices[i]] = true;
  }
  return named;
}

Vec3 transformed(const Affine& m, const Vec3& p) {
  const double x = p.x, y = p.y, z = p.z;
  const auto row = [&](std::size_t r) {
    return static_cast<float>((m[r] * x + m[3 + r] * y) + (m[6 + r] * z + m[9 + r]));
  };
  return {row(0), row(1), row(2)};
}

/// Transforms a displacement by the linear part alone.
Vec3 turned(Affine m, const Vec3& displacement) {
  m[9] = m[10] = m[11] = 0;
  return transformed(m, displacement);
}

}  // namespace

void assemble(Asset& asset) {
  SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  sample_palette(asset, nullptr, 0, Matrix4{}, scratch, palette);

  const std::vector<bool> riding = vertices_of_parts(asset, false);
  const std::vector<bool> used_by_riding = joints_of(asset, riding);
  const std::vector<bool> used_by_skins = joints_of(asset, vertices_of_parts(asset, true));
  std::vector<std::optional<Affine>> placement(asset.joints.size());
  for (std::size_t j = 0; j < asset.joints.size(); ++j) {
    if (!used_by_riding[j] || used_by_skins[j]) continue;
    const Affine global = scratch.globals[asset.joints[j].node];
    const std::optional<Affine> inverse = inverted(global);
    if (!inverse || global == affine_of(Matrix4{})) continue;
    placement[j] = global;
    asset.joints[j].inverse_bind = matrix_of(*inverse);
  }
  const auto placement_of = [&](std::size_t v) {
    const auto& moved = placement[asset.joint_indices[v * asset.influences_per_vertex]];
    return riding[v] && moved ? &*moved : nullptr;
  };
  for (std::size_t v = 0; v < asset.rest_positions.size(); ++v) {
    if (const Affine* moved = placement_of(v))
      asset.rest_positions[v] = transformed(*moved, asset.rest_positions[v]);
  }
  for (std::size_t i = 0; i < asset.morph_vertices.size(); ++i) {
    if (const Affine* moved = placement_of(asset.morph_vertices[i]))
      asset.morph_displacements[i] = turned(*moved, asset.morph_displacements[i]);
  }
}

}  // namespace pelt::asset
