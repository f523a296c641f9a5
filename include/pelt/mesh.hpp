#pragma once

#include <pelt/math.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace pelt {

using Triangle = std::array<std::uint32_t, 3>;

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
};

}  // namespace pelt
