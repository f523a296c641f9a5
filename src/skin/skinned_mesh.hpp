#pragma once

/// A validated mesh.

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/model.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt::detail {

/// Returns the sum over the axes of the largest absolute coordinate of any point, rounded up.
inline float extent_of(std::span<const Vec3> points) {
  Vec3 largest;
  for (const Vec3& p : points)
    largest = {std::max(largest.x, std::fabs(p.x)), std::max(largest.y, std::fabs(p.y)),
               std::max(largest.z, std::fabs(p.z))};
  const double sum = double{largest.x} + double{largest.y} + double{largest.z};
  return std::nextafter(static_cast<float>(sum), std::numeric_limits<float>::infinity());
}

/// A joint that a vertex follows, with its weight.
struct Influence {
  std::uint32_t joint = 0;
  float weight = 0;
};

/// How far a morph target moves a vertex at weight one.
struct Displacement {
  std::uint32_t target = 0;
  Vec3 by;
};

/// Nodes of a tree store joint numbers with 16 bits.
inline constexpr std::uint32_t kMaxJoints = 65535;

/// Rounding analyses count the targets that displace a vertex. Up to this number, in units of
/// 2^-24, terms of second order are negligible.
inline constexpr std::uint32_t kMaxMorphTargets = 65535;

/// A validated skinned mesh in normal form. Influences of a vertex have positive weights that sum
/// to 1 up to rounding, and joints in ascending order. With dual quaternion skinning, the influence
/// with the largest weight comes first, as dual_skin.hpp demands. There are no zero displacements.
/// Vertices that were split at a seam are therefore posed to the same bits.
struct SkinnedMesh {
  std::vector<Vec3> rest_positions;            // [V]
  std::vector<Triangle> triangles;             // [T]
  std::vector<std::uint32_t> influence_begin;  // [V + 1], into influences
  std::vector<Influence> influences;
  std::uint32_t joint_count = 0;
  float rest_extent = 0;  // sum over the axes of the largest coordinate
  bool may_weld = true;   // whether a tree may merge equal vertices

  // The largest number of influences of a vertex with dual quaternion skinning; 0 with linear
  // blend skinning.
  std::uint32_t dual_influences = 0;

  // Displacements by vertex; the targets of each vertex ascend.
  std::vector<float> morph_extents;               // [M] like rest_extent, of the displacements
  std::vector<std::uint32_t> displacement_begin;  // [V + 1], into displacements; [] if M is 0
  std::vector<Displacement> displacements;

  std::vector<float> offset_caps;  // [V] largest offset along each axis; empty: no offsets

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(rest_positions.size()); }
  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangles.size()); }

  std::span<const Influence> influences_of(std::uint32_t vertex) const {
    const std::uint32_t begin = influence_begin[vertex];
    return {influences.data() + begin, influence_begin[vertex + 1] - begin};
  }

  std::span<const Displacement> displacements_of(std::uint32_t vertex) const {
    if (displacement_begin.empty()) return {};
    const std::uint32_t begin = displacement_begin[vertex];
    return {displacements.data() + begin, displacement_begin[vertex + 1] - begin};
  }
};

/// Largest absolute coordinate in the rest pose and posed. Squared distances stay finite in
/// float32.
inline constexpr float kMaxCoordinate = 0x1p60f;

/// Validates `view`, copies it into normal form and fills `report`.
Result<SkinnedMesh> make_skinned_mesh(const SkinnedMeshView& view, const ModelOptions& options,
                                      BuildReport& report);

/// Returns for each triangle [T] the joint with the largest sum of weights over the triangle's
/// vertices; of equal joints, the lowest. O(influences of all triangle vertices, times those of one
/// triangle).
std::vector<std::uint16_t> main_joints(const SkinnedMesh& mesh);

}  // namespace pelt::detail
