#pragma once

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/mesh.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace pelt {

namespace detail {
struct Model;
}

/// What to do with a vertex whose weights sum to something further than 2^-7 from 1. (Sums nearer
/// than that are rounding of the exporter and always renormalised.)
enum class OffWeights {
  refuse,       ///< `build_model` returns an error that names the vertex and its sum
  renormalise,  ///< divide by the sum, as renderers do
};

struct ModelOptions {
  OffWeights off_weights = OffWeights::refuse;

  /// [S][J] joint palettes of typical poses, from the character's own clips for instance: bounds
  /// are then tried on these and triangles grouped so that they stay near each other in them. Half
  /// a dozen make queries up to a fifth faster and the build three times slower. Answers do not
  /// depend on them. May be empty.
  std::span<const Matrix4> sample_palettes = {};
};

/// What `build_model` met on its way.
struct BuildReport {
  std::uint32_t renormalised_vertices = 0;  ///< weights summed to 1 only within more than 2^-16
  std::uint32_t merged_influences = 0;      ///< a joint named twice in one vertex, summed
  std::uint32_t degenerate_triangles = 0;   ///< two or three equal rest positions; kept
};

/// A skinned mesh, checked and prepared for queries. Immutable, cheap to copy (copies share), safe
/// to use from any number of threads.
class PELT_API SkinnedModel {
 public:
  std::uint32_t vertex_count() const;
  std::uint32_t triangle_count() const;
  std::uint32_t joint_count() const;
  std::uint32_t morph_target_count() const;
  const BuildReport& report() const;

  /// What the model takes in memory, shared by all copies: vertices, triangles, tree and bounds.
  std::size_t memory_bytes() const;

  /// For Pelt's own files.
  explicit SkinnedModel(std::shared_ptr<const detail::Model> model);
  const detail::Model& detail() const { return *model_; }

 private:
  std::shared_ptr<const detail::Model> model_;
};

/// Checks the arrays of `mesh` and prepares them for queries, or says which array, index and value
/// break which rule: an index or joint out of range, NaN or infinity, a coordinate beyond 2^60, a
/// negative weight, weights that do not sum to 1, vertices of a morph target that do not ascend.
///
/// Triangles keep their numbers, vertices keep theirs. O(T log T); allocates.
PELT_API Result<SkinnedModel> build_model(const SkinnedMeshView& mesh,
                                          const ModelOptions& options = {});

}  // namespace pelt
