#pragma once

#include <pelt/config.hpp>

#include <pelt/math.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace pelt {

/// The indices of a triangle's three vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// A borrowed view of the morph targets (blend shapes) of a mesh: M targets, with D displacements
/// in total. Without morph targets, all three arrays are empty.
///
/// At weight 1, target m displaces vertex `vertices[i]` by `displacements[i]`, for
/// begin[m] <= i < begin[m + 1]. A target that displaces all vertices must list all vertices.
struct MorphTargetsView {
  std::span<const std::uint32_t> begin;     ///< [M + 1] 0 = begin[0] <= ... <= begin[M] = D
  std::span<const std::uint32_t> vertices;  ///< [D] vertex indices, ascending within each target
  std::span<const Vec3> displacements;      ///< [D] model units, finite
};

/// A borrowed view of the arrays of a skinned mesh with V vertices, T triangles and J joints.
/// `build_model` copies what it needs, so the arrays may be freed afterwards.
///
/// Each vertex has K = `influences_per_vertex` (joint, weight) pairs, called influences. Unused
/// pairs have the weight 0.
///
/// A mesh without joints has no `joints`, no `weights` and the `joint_count` 0. Its model has one
/// joint, which all vertices follow with weight 1: a palette of one matrix places the rest
/// positions, and `Pose::set_vertices` deforms them.
struct SkinnedMeshView {
  std::span<const Vec3> rest_positions;     ///< [V] model units, finite
  std::span<const Triangle> triangles;      ///< [T] indices < V; degenerate triangles are allowed
  std::uint32_t influences_per_vertex = 4;  ///< K >= 1; typical files have 1 to 9

  /// [V][K] indices < joint_count, even if the weight is 0.
  std::span<const std::uint16_t> joints = {};

  std::span<const float> weights = {};  ///< [V][K] >= 0, each row sums to 1
  std::uint32_t joint_count = 0;        ///< J, the number of matrices in a palette; 0: no joints
  MorphTargetsView morph_targets = {};  ///< M morph targets

  /// [V] or empty. The largest offset of each vertex along each axis, 0 to 2^60 units of the frame
  /// of the joint palette. See `Pose::set_offsets`.
  std::span<const float> offset_caps = {};
};

}  // namespace pelt
