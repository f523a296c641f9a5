#pragma once

/// Characters from glTF files: meshes for `build_model`, and joint palettes from clips. All
/// computations from the file to the palette use only + - * / and square roots in a fixed order,
/// and polynomials for sines, so the same file gives the same bits on every platform.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::asset {

inline constexpr std::uint32_t kNoParent = 0xFFFFFFFF;

/// Translation, rotation (unit quaternion x y z w) and scale, applied as T * R * S.
struct Transform {
  std::array<float, 3> translation = {0, 0, 0};
  std::array<float, 4> rotation = {0, 0, 0, 1};
  std::array<float, 3> scale = {1, 1, 1};
};

/// A node of the scene graph. Parents precede their children.
struct Node {
  std::string name;
  std::uint32_t parent = kNoParent;  ///< index into Asset::nodes
  Transform local;                   ///< relative to the parent, in the default pose

  /// Whether the file gives the transform of this node as a matrix. If so, `matrix` replaces
  /// `local`, and no clip animates the transform.
  bool has_matrix = false;

  Matrix4 matrix;  ///< relative to the parent; meaningless if `has_matrix` is false
};

/// A joint of the palette. Its matrix in the palette is placement x global x inverse_bind, where
/// placement is the world matrix of the instance, and global is the transform from the node to the
/// scene.
struct Joint {
  std::uint32_t node = 0;  ///< index into Asset::nodes
  Matrix4 inverse_bind;    ///< rest position -> joint space
};

/// The triangles of one primitive of the file.
struct Part {
  std::string node, mesh, material;  ///< names; empty if the file has none
  std::uint32_t first_triangle = 0, triangle_count = 0;

  /// Whether the part is skinned. If not, all its vertices follow a single joint, which moves like
  /// the part's node. `load_gltf` transforms the rest positions of an unskinned part from mesh
  /// space to the frame of the scene, with the node's transform in the default pose. Exception: the
  /// rest positions stay in mesh space if this transform cannot be inverted, or if a skinned part
  /// uses the same joint.
  bool skinned = false;
};

/// A morph target of one node with a mesh. Nodes that share a mesh have separate targets.
struct MorphTarget {
  std::string name;          ///< from `extras.targetNames` of the mesh; may be empty
  std::uint32_t node = 0;    ///< index into Asset::nodes
  float default_weight = 0;  ///< weight of the node, or else of the mesh
};

enum class Path : std::uint8_t { translation, rotation, scale, weights };
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// One animated property of one node.
struct Channel {
  std::uint32_t node = 0;
  Path path = Path::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;  ///< [K] seconds, strictly ascending, K >= 1

  /// [K][n] values, or [K][3][n] (in-tangent, value, out-tangent) for cubic_spline. n is 4 for
  /// rotation (x y z w) and 3 for translation and scale. For weights, n is the number of the node's
  /// morph targets.
  std::vector<float> values;
};

struct Clip {
  std::string name;    ///< may be empty
  float duration = 0;  ///< seconds; time of the last key of any channel; may be 0
  std::vector<Channel> channels;
};

/// One character: a mesh that merges all skins and parts, its skeleton and its clips.
///
/// Triangles are numbered in the order of the scene: nodes depth-first, primitives in order,
/// including degenerate triangles. The arrays take 12 bytes per triangle, 12 + 6 K per vertex, 68
/// per joint, 16 per vertex that a morph target displaces, and 4 per element of `Channel::times`
/// and `Channel::values`. Nothing else grows with the mesh.
struct PELT_API Asset {
  std::vector<Vec3> rest_positions;          ///< [V] in mesh space; see also Part::skinned
  std::vector<Triangle> triangles;           ///< [T] indices into `rest_positions`
  std::uint32_t influences_per_vertex = 1;   ///< K
  std::vector<std::uint16_t> joint_indices;  ///< [V][K] into `joints`
  std::vector<float> weights;                ///< [V][K] 0 if unused
  std::vector<Joint> joints;                 ///< [J] in the order of the joint palette

  std::vector<MorphTarget> morph_targets;     ///< [M] targets of a node are consecutive
  std::vector<std::uint32_t> morph_begin;     ///< [M + 1] into the next two arrays; empty if M is 0
  std::vector<std::uint32_t> morph_vertices;  ///< vertices that a target displaces, ascending
  std::vector<Vec3> morph_displacements;      ///< not zero; frame like `rest_positions`

  std::vector<Node> nodes;  ///< parents first
  std::vector<Part> parts;  ///< ordered by first_triangle; cover all triangles
  std::vector<Clip> clips;
  std::vector<std::string> warnings;  ///< contents of the file that Pelt ignored

  /// Returns a view of the arrays of this asset, for `build_model`. O(1), copies nothing.
  SkinnedMeshView mesh() const;

  /// Returns the first clip with this name ("" finds an unnamed clip), or null. The clip belongs to
  /// this asset. O(clips).
  const Clip* find_clip(std::string_view name) const;

  /// Name of the node of a joint; may be empty. O(1). Precondition: joint < J.
  const std::string& joint_name(std::uint32_t joint) const;

  /// Part that contains the triangle. O(log parts). Precondition: triangle < T.
  const Part& part_of(std::uint32_t triangle) const;
};

struct GltfOptions {
  /// Include unskinned meshes (weapons, armour).
  bool unskinned_parts = true;

  /// Names of mesh nodes to leave out, with their children.
  std::vector<std::string> exclude_nodes;

  /// Return an error if `exclude_nodes` has a name that no node has.
  bool excluded_must_exist = true;
};

/// Reads a glTF 2.0 file: .glb, or .gltf with data URIs and external files, which must be in the
/// folder of the file or below it. The file is treated as hostile: offsets and sizes are validated
/// before data is read or memory is allocated.
///
/// Rotations are normalised, because files round them. Weights are copied unchanged; `build_model`
/// validates them.
///
/// Cost: O(bytes of the files + size of the asset), plus O(log J) for each joint of a skin.
/// Accessors are decoded once for each use, and a mesh is copied for each node that has it. While
/// loading, memory contains the file, the files that it refers to, and decoded copies, in addition
/// to the asset.
///
/// Limits: the contents may need at most 16 MiB of memory plus 256 bytes for each byte of the file
/// and of the external files. More is an error. On 32-bit platforms, contents that need more than
/// 256 MiB, and JSON with more than two million values, are also errors.
///
/// Returns an error that names the accessor, node or extension. Rotations whose squared length is
/// farther than 1/16 from 1 are an error.
PELT_API Result<Asset> load_gltf(const std::filesystem::path& path,
                                 const GltfOptions& options = {});

/// Reads a glTF file from memory, at the same cost.
///
/// `folder`: where external files are looked up; empty if there are none.
PELT_API Result<Asset> load_gltf(std::span<const std::byte> file,
                                 const std::filesystem::path& folder,
                                 const GltfOptions& options = {});

/// Reusable working memory for sampling; use one per thread. Takes 176 bytes for each node of the
/// largest asset that it was used for.
struct SampleScratch {
  /// A Transform in double.
  struct Local {
    std::array<double, 3> translation;
    std::array<double, 4> rotation;
    std::array<double, 3> scale;
  };

  std::vector<Local> locals;                    // [nodes]
  std::vector<std::array<double, 12>> globals;  // [nodes] first three rows, column-major
};

/// Writes the joint palette of a clip at the time `seconds`.
///
/// `clip`: null selects the default pose of the nodes.
/// `seconds`: clamped to the range of the clip's keys. To loop, pass a time modulo `duration`.
/// `placement`: world matrix of the instance; multiplies from the left.
/// `palette`: precondition: J elements.
///
/// Cost: O(nodes + J + channels * log keys). Allocates nothing after the first call for an asset.
PELT_API void sample_palette(const Asset& asset, const Clip* clip, float seconds,
                             const Matrix4& placement, SampleScratch& scratch,
                             std::span<Matrix4> palette);

/// Writes the weights of the morph targets of a clip at the time `seconds`, for
/// `Pose::set_morph_weights`. Weights that the clip does not animate have their default.
///
/// `clip`: null selects the default weights.
/// `seconds`: clamped as in `sample_palette`.
/// `weights`: precondition: M elements.
///
/// Cost: O(M + channels * log keys). Allocates nothing.
PELT_API void sample_morph_weights(const Asset& asset, const Clip* clip, float seconds,
                                   std::span<float> weights);

}  // namespace pelt::asset
