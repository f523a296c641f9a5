#pragma once

/// Characters from glTF files: meshes for `build_model`, and joint palettes from clips.
///
/// The same file gives the same bits on every platform, because everything is computed with
/// + - * / and square roots in a fixed order. Sines are polynomials.

#include <pelt/config.hpp>

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/result.hpp>
#include <pelt/self_filter.hpp>

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

/// A node of the scene graph. Parents precede their children in Asset::nodes. The default pose
/// consists of the transforms that the file gives for the nodes, without any clip.
struct Node {
  std::string name;
  std::uint32_t parent = kNoParent;  ///< index into Asset::nodes
  Transform local;                   ///< relative to the parent, in the default pose

  /// Whether the file gives the transform of this node as a matrix. If so, `matrix` replaces
  /// `local`, and no clip animates the transform.
  bool has_matrix = false;

  Matrix4 matrix;  ///< relative to the parent, like `local`; meaningless if not `has_matrix`
};

/// A joint of the palette. Its matrix in the palette is placement x global x inverse_bind.
/// `placement` is the world matrix of the instance. `global` transforms from the frame of the
/// joint's node to the frame of the scene.
struct Joint {
  std::uint32_t node = 0;  ///< index into Asset::nodes
  Matrix4 inverse_bind;    ///< rest position -> joint space
};

/// The triangles of one primitive of the file.
struct Part {
  std::string node, mesh, material;  ///< names; empty if the file has none
  std::uint32_t first_triangle = 0, triangle_count = 0;

  /// Whether the part has a skin. All vertices of an unskinned part follow a single joint, which
  /// moves like the part's node. The rest positions of a skinned part are in mesh space, those of
  /// an unskinned part in the frame of the scene, where the default pose places them. Exception:
  /// they stay in mesh space if the node's transform has no inverse, or if a skin lists the node as
  /// a joint with the identity as inverse bind matrix, and skinned vertices follow it.
  bool skinned = false;
};

/// A morph target of one node with a mesh. Nodes that share a mesh have separate targets.
struct MorphTarget {
  std::string name;          ///< from `extras.targetNames` of the mesh; may be empty
  std::uint32_t node = 0;    ///< index into Asset::nodes
  float default_weight = 0;  ///< from the node; if the node has no weights, from the mesh
};

enum class Path : std::uint8_t { translation, rotation, scale, weights };
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// One animated property of one node.
struct Channel {
  std::uint32_t node = 0;
  Path path = Path::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;  ///< [keys] seconds, strictly ascending, at least one

  /// [keys][n] values, or [keys][3][n] (in-tangent, value, out-tangent) for cubic_spline. n is 4
  /// for rotation (x y z w) and 3 for translation and scale. For weights, n is the number of the
  /// node's morph targets.
  std::vector<float> values;
};

struct Clip {
  std::string name;    ///< may be empty
  float duration = 0;  ///< seconds; time of the last key of any channel; may be 0
  std::vector<Channel> channels;
};

/// One character: a skeleton, its clips, and a single mesh that contains all parts.
///
/// Triangles are numbered in the order of the file: nodes of the scene depth-first, then primitives
/// of a node, then triangles of a primitive. Degenerate triangles are included.
///
/// Memory: with K = `influences_per_vertex`, 12 bytes per triangle, 12 + 6 K bytes per vertex, 16
/// bytes per displacement of a morph target, 68 bytes per joint, and 4 bytes per element of
/// `Channel::times` and `Channel::values`. Nothing else grows with the size of the mesh.
struct PELT_API Asset {
  std::vector<Vec3> rest_positions;          ///< [V] frame: see Part::skinned
  std::vector<Triangle> triangles;           ///< [T] indices into `rest_positions`
  std::uint32_t influences_per_vertex = 1;   ///< K (joint, weight) pairs
  std::vector<std::uint16_t> joint_indices;  ///< [V][K] into `joints`
  std::vector<float> weights;                ///< [V][K] 0 if unused
  std::vector<Joint> joints;                 ///< [J] in the order of the joint palette

  std::vector<MorphTarget> morph_targets;  ///< [M] targets of a node are consecutive

  /// D displacements: target m displaces vertex morph_vertices[i] by morph_displacements[i] for
  /// morph_begin[m] <= i < morph_begin[m + 1].
  std::vector<std::uint32_t> morph_begin;     ///< [M + 1] from 0 to D; empty if M is 0
  std::vector<std::uint32_t> morph_vertices;  ///< [D] ascending within each target
  std::vector<Vec3> morph_displacements;      ///< [D] not zero; in the frame of `rest_positions`

  std::vector<Node> nodes;  ///< parents first
  std::vector<Part> parts;  ///< ordered by first_triangle; each triangle is in one part
  std::vector<Clip> clips;
  std::vector<std::string> warnings;  ///< describe contents of the file that Pelt ignored

  /// Returns a view of the arrays of this asset, for `build_model`. O(1), copies nothing.
  SkinnedMeshView mesh() const;

  /// Returns the first element of `clips` with this name, or null if there is none. "" finds an
  /// unnamed clip. O(clips).
  const Clip* find_clip(std::string_view name) const;

  /// Returns the name of the joint's node; may be empty. O(1). Precondition: joint < J.
  const std::string& joint_name(std::uint32_t joint) const;

  /// Returns the part that contains the triangle. O(log parts). Precondition: triangle < T.
  const Part& part_of(std::uint32_t triangle) const;
};

struct GltfOptions {
  /// Include meshes without a skin, such as weapons and armour.
  bool unskinned_parts = true;

  /// Leave out the meshes of nodes with these names, and of all nodes below them.
  std::vector<std::string> exclude_nodes;

  /// Return an error if `exclude_nodes` contains a name that no node of the scene has.
  bool excluded_must_exist = true;
};

/// Reads a glTF 2.0 file: .glb, or .gltf with data URIs and external files. External files must be
/// in the folder of the file or below it. The file need not be trusted: offsets and sizes are
/// validated before data is read or memory is allocated.
///
/// Rotations are normalised, because the file stores rounded numbers. Weights of vertices are
/// copied unchanged; `build_model` validates them.
///
/// Cost: O(bytes of all files + size of the asset), plus O(log J) for each joint of a skin. An
/// accessor is decoded once for each use. A mesh is copied for each node that uses it.
///
/// Allocates the asset. Until the function returns, the file, its external files and decoded copies
/// are also in memory.
///
/// Limits: let F be the number of bytes of the file and its external files. Contents that need more
/// memory than 16 MiB + 256 F bytes, or than 48 GiB, are an error. On 32-bit platforms, contents
/// that need more than 256 MiB are an error, and so is JSON with more than two million values.
///
/// Returns an error that names the accessor, node or extension. A rotation is an error if its
/// squared length differs from 1 by more than 1/16.
PELT_API Result<Asset> load_gltf(const std::filesystem::path& path,
                                 const GltfOptions& options = {});

/// Reads a glTF file from memory, with the same cost, limits and errors.
///
/// `folder`: folder of the external files; may be empty if there are none.
PELT_API Result<Asset> load_gltf(std::span<const std::byte> file,
                                 const std::filesystem::path& folder,
                                 const GltfOptions& options = {});

/// Reusable working memory for `sample_palette`. Use one per thread. Memory: 176 bytes per node of
/// the largest asset so far.
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

/// Writes the joint palette of a clip at the time `seconds`, for `Pose::set_palette`.
///
/// `clip`: null selects the default pose.
/// `seconds`: each channel clamps this time to the range of its keys. To loop, pass a time modulo
///   `duration`.
/// `placement`: world matrix of the instance; multiplies from the left.
/// `palette`: precondition: J elements.
///
/// Cost: O(nodes + J + channels * log keys). Allocates nothing after the first call for an asset.
PELT_API void sample_palette(const Asset& asset, const Clip* clip, float seconds,
                             const Matrix4& placement, SampleScratch& scratch,
                             std::span<Matrix4> palette);

/// Writes the morph weights of a clip at the time `seconds`, for `Pose::set_morph_weights`. A
/// target that the clip does not animate gets its `default_weight`.
///
/// `clip`: null selects the default weights.
/// `seconds`: clamped as in `sample_palette`.
/// `weights`: precondition: M elements.
///
/// Cost: O(M + channels * log keys). Allocates nothing.
PELT_API void sample_morph_weights(const Asset& asset, const Clip* clip, float seconds,
                                   std::span<float> weights);

/// Returns the rigid bodies of the joints, for `near_joints`. Joints that no clip moves relative to
/// each other are one body; if no clip moves any joint, each joint is a body. Motion of less than
/// half a degree, or of 0.4 % of a length or scale, does not count.
///
/// Cost: O(nodes + J + keys of all clips). Allocates.
PELT_API JointBodies joint_bodies(const Asset& asset);

}  // namespace pelt::asset
