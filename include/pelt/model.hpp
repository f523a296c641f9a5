#pragma once

#include <pelt/config.hpp>

#include <pelt/mesh.hpp>
#include <pelt/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct Model;
}

class Surface;

/// Policy for vertices whose sum of weights differs from 1 by more than 2^-7. A difference of at
/// most 2^-7 counts as rounding by the exporter. With either policy, `build_model` divides
/// such weights by their sum.
enum class OffWeights {
  refuse,       ///< `build_model` returns an error that names the vertex and the sum
  renormalise,  ///< `build_model` divides the weights by their sum, as renderers do
};

/// How the joints of a vertex are blended. With either kind, a vertex that follows one rigid joint
/// moves with this joint.
enum class Skinning : std::uint8_t {
  /// A posed vertex is the weighted mean of its images under the joint matrices. Where joints twist
  /// against each other, skin collapses.
  linear,

  /// A posed vertex is moved by the weighted sum of the joints' dual quaternions (Kavan, Collins,
  /// Zara & O'Sullivan 2007). Skin does not collapse, because every vertex is moved rigidly. Joints
  /// must be rigid. The pivot of a vertex is the joint with its largest weight, the lowest one of
  /// equal weights. A quaternion whose product with that of the pivot is negative is negated.
  dual_quaternion,
};

/// Largest number of influences of a vertex in a model with dual quaternion skinning.
inline constexpr std::uint32_t kMaxDualInfluences = 16;

struct ModelOptions {
  OffWeights off_weights = OffWeights::refuse;

  /// With `Skinning::dual_quaternion`, `build_model` returns an error if a vertex follows more than
  /// `kMaxDualInfluences` joints.
  Skinning skinning = Skinning::linear;

  /// [S][J] joint palettes of S typical poses, for example from the character's clips; may be
  /// empty. The tree is optimised for these poses, but answers do not depend on them. With six
  /// poses, queries are up to 20 % faster, and the build takes three times as long.
  std::span<const Matrix4> sample_palettes = {};

  /// Whether to merge vertices that are equal in every bit of rest position, influences and
  /// displacements, and have no offset cap above 0. Files repeat such vertices at seams of
  /// textures, and queries are faster if they pose each of them once. `Pose::set_vertices` then
  /// refuses different positions for merged vertices. If false, a surface is not closed along such
  /// seams (see `Surface::is_closed`).
  bool weld = true;
};

/// Counts of defects that `build_model` found in the mesh.
struct BuildReport {
  /// Vertices whose sum of weights differed from 1 by more than 2^-16. Smaller differences are
  /// rounding of floats: they are corrected, too, but not counted.
  std::uint32_t renormalised_vertices = 0;

  /// (joint, weight) pairs whose weight was added to another pair of the same vertex and joint.
  std::uint32_t merged_influences = 0;

  /// Triangles with two or three equal rest positions. They are not removed.
  std::uint32_t degenerate_triangles = 0;
};

/// A validated skinned mesh, prepared for queries. Immutable, cheap to copy (copies share the
/// data), safe to use from any number of threads.
class PELT_API SkinnedModel {
 public:
  std::uint32_t vertex_count() const;
  std::uint32_t triangle_count() const;
  std::uint32_t joint_count() const;
  Skinning skinning() const;
  std::uint32_t morph_target_count() const;
  const BuildReport& report() const;

  /// Returns how the triangles are connected (pelt/surface.hpp). The first call, or the first query
  /// that needs the surface, computes it, in O(T log T), and allocates about 14 bytes per triangle.
  /// Copies of the model share it. Safe from any number of threads; answers do not depend on the
  /// first caller.
  Surface surface() const;

  /// Bytes of the data that all copies share: vertices, triangles, tree and bounds, but not the
  /// surface.
  std::size_t memory_bytes() const;

  /// For internal use.
  explicit SkinnedModel(std::shared_ptr<const detail::Model> model);
  const detail::Model& detail() const { return *model_; }

 private:
  std::shared_ptr<const detail::Model> model_;
};

/// Validates the arrays of `mesh` and builds a model from them. Triangles and vertices keep their
/// indices.
///
/// Cost: O(T log T). Allocates.
///
/// Returns an error if
/// - there are no triangles,
/// - an array or a count has an invalid size,
/// - an index is out of range,
/// - a number is NaN or infinite,
/// - the magnitude of a coordinate or an offset cap is more than 2^60,
/// - a weight or an offset cap is negative,
/// - the weights of a vertex do not sum to 1 (see `OffWeights`), or
/// - the vertices of a morph target are not in ascending order.
/// The error names the array, the index and the value.
PELT_API Result<SkinnedModel> build_model(const SkinnedMeshView& mesh,
                                          const ModelOptions& options = {});

/// Returns the model as bytes. `load_model` of these bytes is more than ten times as fast as
/// `build_model`. Equal models give equal bytes. docs/prepared-format.md describes the format. A
/// later version of Pelt may reject this format, so keep the data from which the model was built.
///
/// Cost: O(bytes). Allocates.
PELT_API std::vector<std::byte> save_model(const SkinnedModel& model);

/// Reads a model written by `save_model`. Queries of the loaded model give the same answers and do
/// the same work as queries of the saved model.
///
/// The bytes are treated as hostile: `load_model` rejects everything that could make queries read
/// outside their memory or run forever. `load_model` does not check that bounds enclose the
/// vertices: a file with forged bounds can make queries miss contacts, but cannot cause anything
/// worse.
///
/// Cost: O(bytes). Allocates at most a small multiple of the size of `file`.
///
/// Returns an error that says what is invalid.
PELT_API Result<SkinnedModel> load_model(std::span<const std::byte> file);

/// Returns whether the bytes start like a prepared model. `load_model` may still return an error.
///
/// Cost: O(1).
PELT_API bool is_prepared_model(std::span<const std::byte> file);

}  // namespace pelt
