#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/math.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace pelt {

using Triangle = std::array<std::uint32_t, 3>;

/// Morph targets (blend shapes) of a mesh, all in the same three arrays; without elements: none.
/// Target m displaces the vertices `vertices[i]` by `displacements[i]` for i from begin[m] up to,
/// but without, begin[m + 1]. A target in which every vertex has a displacement names them all.
struct MorphTargetsView {
  std::span<const std::uint32_t> begin;     ///< [M + 1] from 0 to D, never descending; or empty
  std::span<const std::uint32_t> vertices;  ///< [D] indices < V, ascending in each target
  std::span<const Vec3> displacements;      ///< [D] model units, finite
};

/// A borrowed view of a skinned mesh: what an engine has in its arrays. Nothing is copied before
/// `build_model`, and nothing is kept of the view after it.
///
/// Each vertex has K = `influences_per_vertex` (joint, weight) pairs; unused ones have weight 0.
struct SkinnedMeshView {
  std::span<const Vec3> rest_positions;     ///< [V] model units, finite
  std::span<const Triangle> triangles;      ///< [T] indices < V; degenerate ones are allowed
  std::uint32_t influences_per_vertex = 4;  ///< K >= 1; real files have 1 to 9
  std::span<const std::uint16_t> joints;  ///< [V][K] indices < joint_count, also where weight is 0
  std::span<const float> weights;         ///< [V][K] >= 0, each row sums to 1
  std::uint32_t joint_count = 0;          ///< J, the number of matrices in a joint palette
  MorphTargetsView morph_targets = {};    ///< M of them, added to the rest positions by weight
};

}  // namespace pelt
