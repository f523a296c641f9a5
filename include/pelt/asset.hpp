#pragma once

/// Characters from files: meshes, skeletons and clips, turned into what the core takes. Everything
/// from the file to the palette uses only + - * / and square roots in a fixed order (sines by own
/// polynomials), so that the same file gives the same bits on every platform.

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

/// Translation, rotation (unit quaternion x y z w) and scale: T * R * S.
struct Transform {
  std::array<float, 3> translation = {0, 0, 0};
  std::array<float, 4> rotation = {0, 0, 0, 1};
  std::array<float, 3> scale = {1, 1, 1};
};

/// A node of the scene graph. Parents come before their children.
struct Node {
  std::string name;
  std::uint32_t parent = kNoParent;  ///< index into Asset::nodes
  Transform local;                   ///< relative to the parent, in the default pose
  bool has_matrix = false;           ///< the file gave `matrix`, not `local`; never animated
  Matrix4 matrix;                    ///< relative to the parent
};

/// Entry j of the joint palette is `instance placement * global(node) * inverse_bind`.
struct Joint {
  std::uint32_t node = 0;  ///< index into Asset::nodes
  Matrix4 inverse_bind;    ///< rest position -> joint space
};

/// A range of triangles that came from one primitive of the file.
struct Part {
  std::string node, mesh, material;  ///< names; empty where the file has none
  std::uint32_t first_triangle = 0, triangle_count = 0;
  bool skinned = false;  ///< false: an unskinned mesh that rides on its node as on one joint; its
                         ///< rest positions are where the default pose has them
};

/// A morph target of one node with a mesh; nodes that share a mesh have targets of their own.
struct MorphTarget {
  std::string name;          ///< of the mesh's `extras.targetNames`; may be empty
  std::uint32_t node = 0;    ///< index into Asset::nodes
  float default_weight = 0;  ///< the node's, or else the mesh's
};

enum class Path : std::uint8_t { translation, rotation, scale, weights };
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// One animated property of one node.
struct Channel {
  std::uint32_t node = 0;
  Path path = Path::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;   ///< [K] seconds, strictly ascending, K >= 1
  std::vector<float> values;  ///< [K][n], n = 4 for rotation (x y z w), for weights as many as the
                              ///< node has morph targets, else 3;
                              ///< [K][3][n] (in-tangent, value, out-tangent) for cubic_spline
};

struct Clip {
  std::string name;    ///< may be empty
  float duration = 0;  ///< seconds; time of the last key of any channel, may be 0
  std::vector<Channel> channels;
};

/// One character: a mesh with all its skins and parts merged, its skeleton and its clips.
///
/// Triangles are numbered in scene order (nodes depth-first, primitives in order, degenerate ones
/// kept). The arrays take 12 bytes a triangle, 12 + 6 K a vertex, 68 a joint, 16 for each vertex
/// that a morph target displaces, and 4 for each time and each number of a clip's keys; nothing
/// else in it grows with the mesh.
struct PELT_API Asset {
  std::vector<Vec3> rest_positions;          ///< [V] see Part::skinned for their frame
  std::vector<Triangle> triangles;           ///< [T] indices into `rest_positions`
  std::uint32_t influences_per_vertex = 1;   ///< K
  std::vector<std::uint16_t> joint_indices;  ///< [V][K] into `joints`
  std::vector<float> weights;                ///< [V][K] 0 where unused
  std::vector<Joint> joints;                 ///< [J] in the order of the joint palette

  std::vector<MorphTarget> morph_targets;     ///< [M] those of a node one after the other
  std::vector<std::uint32_t> morph_begin;     ///< [M + 1] into the next two; empty if M is 0
  std::vector<std::uint32_t> morph_vertices;  ///< of each target ascending; others stay in place
  std::vector<Vec3> morph_displacements;      ///< not zero; frame as that of `rest_positions`

  std::vector<Node> nodes;  ///< parents first
  std::vector<Part> parts;  ///< in order of first_triangle, covering all triangles
  std::vector<Clip> clips;
  std::vector<std::string> warnings;  ///< what the file has and Pelt passed over

  /// For `build_model`; borrows from this asset. O(1), copies nothing.
  SkinnedMeshView mesh() const;

  /// The first clip of that name ("" finds an unnamed clip), or null. Borrowed from this asset.
  /// O(clips).
  const Clip* find_clip(std::string_view name) const;

  /// Name of joint `joint`'s node; may be empty. O(1). Precondition: joint < J.
  const std::string& joint_name(std::uint32_t joint) const;

  /// The part that has the triangle. O(log parts). Precondition: triangle < T.
  const Part& part_of(std::uint32_t triangle) const;
};

struct GltfOptions {
  /// Take along unskinned meshes (weapons, armour).
  bool unskinned_parts = true;
  /// Names of mesh nodes to leave out, with their children.
  std::vector<std::string> exclude_nodes;
  /// Refuse a name to leave out that no node has.
  bool excluded_must_exist = true;
};

/// Reads a glTF 2.0 file, .glb or .gltf with external files (searched beside it, never outside its
/// folder) and data URIs. The file is treated as hostile: every range is checked before it is
/// used or allocated, and the message names the accessor, node or extension that is wrong.
///
/// Rotations are scaled to length 1 (files round them) and refused when their squared length is
/// further than 1/16 from 1. Weights stay as they are in the file: `build_model` judges them.
///
/// O(bytes of the file + size of the asset) but for a factor log J for joints: accessors are
/// decoded once for each use, and a mesh is copied for each node that has it. On the way memory
/// holds the file, what it refers to, and decoded copies of it, beside the asset. No file takes
/// more than 256 times its size, 16 MiB aside: instances beyond that are refused. Where addresses
/// have 32 bits, none takes more than 256 MiB, nor has more than two million values in its JSON.
PELT_API Result<Asset> load_gltf(const std::filesystem::path& path,
                                 const GltfOptions& options = {});

/// The same from memory, at the same cost. `folder` is where external files are looked for; empty:
/// there are none.
PELT_API Result<Asset> load_gltf(std::span<const std::byte> file,
                                 const std::filesystem::path& folder,
                                 const GltfOptions& options = {});

/// Reusable memory and working state for sampling; one per thread. 176 bytes for each node of the
/// largest asset that it was used for.
struct SampleScratch {
  /// A Transform in double.
  struct Local {
    std::array<double, 3> translation;
    std::array<double, 4> rotation;
    std::array<double, 3> scale;
  };

  std::vector<Local> locals;                    // [nodes]
  std::vector<std::array<double, 12>> globals;  // [nodes] three rows by columns
};

/// Writes the joint palette at `seconds` of `clip`: keys outside the clip's range are clamped
/// (loop by passing a time modulo `duration`); null: the default node pose. `placement` stands
/// before everything, as the instance's world matrix. Precondition: `palette` has J elements.
/// O(nodes + J + channels * log keys); allocates nothing after the first call of an asset.
PELT_API void sample_palette(const Asset& asset, const Clip* clip, float seconds,
                             const Matrix4& placement, SampleScratch& scratch,
                             std::span<Matrix4> palette);

/// Writes the weights of the morph targets at `seconds` of `clip`, as `sample_palette` does the
/// joints: those that the clip does not animate have their default. For `Pose::set_morph_weights`.
/// Precondition: `weights` has M elements. O(M + channels * log keys); allocates nothing.
PELT_API void sample_morph_weights(const Asset& asset, const Clip* clip, float seconds,
                                   std::span<float> weights);

}  // namespace pelt::asset
