#pragma once

/// The JSON part of a glTF file, with types. Every field that Pelt needs is validated here by
/// itself, and every index is in range. Properties that depend on the bytes (ranges, equal counts
/// of related accessors) are validated where the bytes are read.

#include <pelt/asset.hpp>

#include <optional>

namespace pelt::asset {

enum class ComponentType : std::uint8_t { i8, u8, i16, u16, u32, f32 };

enum class ElementType : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };

std::size_t byte_size(ComponentType type);
std::size_t component_count(ElementType type);
const char* name(ElementType type);  ///< as the format writes it

struct GltfBuffer {
  std::optional<std::string> uri;
  std::uint64_t length = 0;
  bool meshopt_fallback = false;  ///< stands for compressed views; has no bytes of its own
};

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

/// Location of a view's compressed bytes, from EXT_meshopt_compression.
struct GltfMeshopt {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0, count = 0;
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
};

struct GltfView {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0;  ///< 0: elements without gaps
  std::optional<GltfMeshopt> meshopt;
};

struct GltfSparse {
  std::uint64_t count = 0;
  std::uint32_t index_view = 0;
  std::uint64_t index_offset = 0;
  ComponentType index_type = ComponentType::u8;
  std::uint32_t value_view = 0;
  std::uint64_t value_offset = 0;
};

struct GltfAccessor {
  std::optional<std::uint32_t> view;  ///< none: zeros
  std::uint64_t offset = 0, count = 0;
  ComponentType component = ComponentType::f32;
  bool normalised = false;
  ElementType type = ElementType::scalar;
  std::optional<GltfSparse> sparse;
};

enum class PrimitiveMode : std::uint8_t { triangles, strip, fan, points_or_lines };

/// JOINTS_n and WEIGHTS_n.
struct GltfInfluenceSet {
  std::uint32_t joints = 0, weights = 0;
};

struct GltfPrimitive {
  PrimitiveMode mode = PrimitiveMode::triangles;
  std::optional<std::uint32_t> indices, positions, material;
  std::vector<GltfInfluenceSet> influence_sets;
  std::vector<std::optional<std::uint32_t>> target_positions;  ///< of the morph targets
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
  std::vector<float> weights;             ///< of the morph targets; empty: all 0
  std::vector<std::string> target_names;  ///< of `extras`, as many as there are

  /// Largest number of a primitive; all primitives should have the same number.
  std::size_t target_count() const;
};

struct GltfSkin {
  std::string name;
  std::vector<std::uint32_t> joints;
  std::optional<std::uint32_t> inverse_bind_matrices;
};

struct GltfNode {
  std::string name;
  std::vector<std::uint32_t> children;
  Transform local;
  bool has_matrix = false;
  Matrix4 matrix;
  std::optional<std::uint32_t> mesh, skin;
  std::vector<float> weights;  ///< of the mesh's morph targets; empty: the mesh's own
};

struct GltfSampler {
  std::uint32_t times = 0, values = 0;
  Interpolation interpolation = Interpolation::linear;
};

enum class GltfPath : std::uint8_t { translation, rotation, scale, weights, unknown };

struct GltfChannel {
  std::uint32_t sampler = 0;
  std::optional<std::uint32_t> node;
  GltfPath path = GltfPath::unknown;
};

struct GltfAnimation {
  std::string name;
  std::vector<GltfSampler> samplers;
  std::vector<GltfChannel> channels;
};

struct GltfDocument {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
  std::vector<std::string> materials;
  std::vector<GltfSkin> skins;
  std::vector<GltfNode> nodes;
  std::vector<std::vector<std::uint32_t>> scenes;  ///< the roots of each
  std::optional<std::uint32_t> scene;              ///< the one to show
  std::vector<GltfAnimation> animations;
  std::vector<std::string> passed_over_extensions;  ///< used, not required, unknown to Pelt
};

/// Reads the JSON text of a glTF 2.0 file. Returns an error that names the invalid field, or a
/// required extension that Pelt does not support.
Result<GltfDocument> read_document(std::string_view json);

}  // namespace pelt::asset
