#include "asset/document.hpp"
#include "asset/container.hpp"
#include "asset/json_object.hpp"
#include "asset/parsed_json.hpp"
#include "asset/transform.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pelt::asset {

namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// A keyword of the format and its meaning.
template <typename T>
struct Word {
  const char* text;
  T value;
};

constexpr Word<ElementType> kElementTypes[] = {
    {"SCALAR", ElementType::scalar}, {"VEC2", ElementType::vec2}, {"VEC3", ElementType::vec3},
    {"VEC4", ElementType::vec4},     {"MAT2", ElementType::mat2}, {"MAT3", ElementType::mat3},
    {"MAT4", ElementType::mat4}};

/// Returns the value of the keyword at `key`. If the field is absent, returns the first value,
/// which is the default.
template <typename T, std::size_t N>
T read_word(const JsonObject& json, const char* key, const Word<T> (&words)[N]) {
  if (!json.has(key)) return words[0].value;
  const std::string text = json.text(key);
  for (const Word<T>& word : words) {
    if (word.text == text) return word.value;
  }
  json.refuse(key, "unknown value " + text::quoted(text));
  return words[0].value;
}

ComponentType read_component_type(const JsonObject& json) {
  switch (json.count("componentType")) {
    case 5120:
      return ComponentType::i8;
    case 5121:
      return ComponentType::u8;
    case 5122:
      return ComponentType::i16;
    case 5123:
      return ComponentType::u16;
    case 5125:
      return ComponentType::u32;
    case 5126:
      return ComponentType::f32;
    default:
      json.refuse("componentType", "must be 5120 to 5126, and not 5124");
  }
  return ComponentType::f32;
}

GltfBuffer read_buffer(const JsonObject& json) {
  GltfBuffer buffer;
  if (json.has("uri")) buffer.uri = json.text("uri");
  buffer.length = json.count("byteLength");
  buffer.meshopt_fallback = json.object("extensions").object(kMeshopt).flag("fallback");
  return buffer;
}

GltfMeshopt read_meshopt(const JsonObject& json, std::size_t buffer_count) {
  static constexpr Word<MeshoptMode> kModes[] = {{"ATTRIBUTES", MeshoptMode::attributes},
                                                 {"TRIANGLES", MeshoptMode::triangles},
                                                 {"INDICES", MeshoptMode::indices}};
  static constexpr Word<MeshoptFilter> kFilters[] = {{"NONE", MeshoptFilter::none},
                                                     {"OCTAHEDRAL", MeshoptFilter::octahedral},
                                                     {"QUATERNION", MeshoptFilter::quaternion},
                                                     {"EXPONENTIAL", MeshoptFilter::exponential}};
  GltfMeshopt meshopt;
  meshopt.buffer = json.index("buffer", buffer_count);
  meshopt.offset = json.count("byteOffset", 0);
  meshopt.length = json.count("byteLength");
  meshopt.stride = json.count("byteStride");
  meshopt.count = json.count("count");
  if (!json.has("mode")) json.refuse("mode", "is missing");
  meshopt.mode = read_word(json, "mode", kModes);
  meshopt.filter = read_word(json, "filter", kFilters);
  return meshopt;
}

GltfView read_view(const JsonObject& json, std::size_t buffer_count) {
  GltfView view;
  view.buffer = json.index("buffer", buffer_count);
  view.offset = json.count("byteOffset", 0);
  view.length = json.count("byteLength");
  view.stride = json.count("byteStride", 0);
  if (view.stride > 252) json.refuse("byteStride", "must be at most 252");
  const JsonObject extensions = json.object("extensions");
  if (extensions.has(kMeshopt)) {
    view.meshopt = read_meshopt(extensions.object(kMeshopt), buffer_count);
  }
  return view;
}

GltfSparse read_sparse(const JsonObject& json, std::size_t view_count) {
  const JsonObject indices = json.object("indices");
  const JsonObject values = json.object("values");
  GltfSparse sparse;
  sparse.count = json.count("count");
  sparse.index_view = indices.index("bufferView", view_count);
  sparse.index_offset = indices.count("byteOffset", 0);
  sparse.index_type = read_component_type(indices);
  sparse.value_view = values.index("bufferView", view_count);
  sparse.value_offset = values.count("byteOffset", 0);
  return sparse;
}

GltfAccessor read_accessor(const JsonObject& json, std::size_t view_count) {
  GltfAccessor accessor;
  accessor.view = json.optional_index("bufferView", view_count);
  accessor.offset = json.count("byteOffset", 0);
  accessor.count = json.count("count");
  accessor.component = read_component_type(json);
  accessor.normalised = json.flag("normalized");
  if (!json.has("type")) json.refuse("type", "is missing");
  accessor.type = read_word(json, "type", kElementTypes);
  if (json.has("sparse")) accessor.sparse = read_sparse(json.object("sparse"), view_count);
  return accessor;
}

/// JOINTS_0 and WEIGHTS_0, JOINTS_1 and WEIGHTS_1 ... without a gap.
std::vector<GltfInfluenceSet> read_influence_sets(const JsonObject& attributes,
                                                  std::size_t accessor_count) {
  std::vector<GltfInfluenceSet> sets;
  std::size_t names = 0;
  for (const std::string& key : attributes.keys()) {
    names += key.starts_with("JOINTS_") || key.starts_with("WEIGHTS_");
  }
  while (2 * sets.size() < names) {
    const std::string joints = "JOINTS_" + std::to_string(sets.size());
    const std::string weights = "WEIGHTS_" + std::to_string(sets.size());
    GltfInfluenceSet set;
    set.joints = attributes.index(joints.c_str(), accessor_count);
    set.weights = attributes.index(weights.c_str(), accessor_count);
    if (!attributes.has(joints.c_str()) || !attributes.has(weights.c_str())) break;
    sets.push_back(set);
  }
  return sets;
}

PrimitiveMode read_mode(const JsonObject& json) {
  const std::uint64_t mode = json.count("mode", 4);
  if (mode > 6) json.refuse("mode", "must be 0 to 6");
  if (mode == 4) return PrimitiveMode::triangles;
  if (mode == 5) return PrimitiveMode::strip;
  return mode == 6 ? PrimitiveMode::fan : PrimitiveMode::points_or_lines;
}

GltfPrimitive read_primitive(const JsonObject& json, std::size_t accessor_count,
                             std::size_t material_count) {
  const JsonObject attributes = json.object("attributes");
  GltfPrimitive primitive;
  primitive.mode = read_mode(json);
  primitive.indices = json.optional_index("indices", accessor_count);
  primitive.positions = attributes.optional_index("POSITION", accessor_count);
  primitive.material = json.optional_index("material", material_count);
  primitive.influence_sets = read_influence_sets(attributes, accessor_count);
  for (const JsonObject& target : json.objects("targets")) {
    primitive.target_positions.push_back(target.optional_index("POSITION", accessor_count));
  }
  return primitive;
}

/// Reads the names that exporters store in `extras` by convention. Ignores all other extras.
std::vector<std::string> read_target_names(const JsonObject& json) {
  if (!json.is_object("extras")) return {};
  const JsonObject extras = json.object("extras");
  return extras.is_list_of_texts("targetNames") ? extras.texts("targetNames")
                                                : std::vector<std::string>();
}

GltfMesh read_mesh(const JsonObject& json, std::size_t accessor_count, std::size_t material_count) {
  GltfMesh mesh;
  mesh.name = json.text("name");
  mesh.weights = json.floats("weights");
  mesh.target_names = read_target_names(json);
  for (const JsonObject& primitive : json.objects("primitives")) {
    mesh.primitives.push_back(read_primitive(primitive, accessor_count, material_count));
  }
  return mesh;
}

GltfSkin read_skin(const JsonObject& json, std::size_t node_count, std::size_t accessor_count) {
  GltfSkin skin;
  skin.name = json.text("name");
  skin.joints = json.indices("joints", node_count);
  skin.inverse_bind_matrices = json.optional_index("inverseBindMatrices", accessor_count);
  if (skin.joints.empty()) json.refuse("joints", "must have at least one joint");
  return skin;
}

Transform read_transform(const JsonObject& json) {
  Transform local;
  local.translation = json.floats<3>("translation", {0, 0, 0});
  local.rotation = json.floats<4>("rotation", {0, 0, 0, 1});
  local.scale = json.floats<3>("scale", {1, 1, 1});
  if (!normalise(local.rotation)) json.refuse("rotation", "must be a unit quaternion");
  return local;
}

GltfNode read_node(const JsonObject& json, const JsonObject& root) {
  GltfNode node;
  node.name = json.text("name");
  node.children = json.indices("children", root.array_size("nodes"));
  node.mesh = json.optional_index("mesh", root.array_size("meshes"));
  node.skin = json.optional_index("skin", root.array_size("skins"));
  node.weights = json.floats("weights");
  node.local = read_transform(json);
  node.has_matrix = json.has("matrix");
  node.matrix.m = json.floats<16>("matrix", node.matrix.m);
  if (!make_affine(node.matrix)) json.refuse("matrix", "its last row must be 0 0 0 1");
  return node;
}

GltfSampler read_sampler(const JsonObject& json, std::size_t accessor_count) {
  static constexpr Word<Interpolation> kInterpolations[] = {
      {"LINEAR", Interpolation::linear},
      {"STEP", Interpolation::step},
      {"CUBICSPLINE", Interpolation::cubic_spline}};
  GltfSampler sampler;
  sampler.times = json.index("input", accessor_count);
  sampler.values = json.index("output", accessor_count);
  sampler.interpolation = read_word(json, "interpolation", kInterpolations);
  return sampler;
}

GltfChannel read_channel(const JsonObject& json, std::size_t sampler_count,
                         std::size_t node_count) {
  const JsonObject target = json.object("target");
  const std::string path = target.text("path");
  GltfChannel channel;
  channel.sampler = json.index("sampler", sampler_count);
  channel.node = target.optional_index("node", node_count);
  if (path == "translation") channel.path = GltfPath::translation;
  if (path == "rotation") channel.path = GltfPath::rotation;
  if (path == "scale") channel.path = GltfPath::scale;
  if (path == "weights") channel.path = GltfPath::weights;
  return channel;
}

GltfAnimation read_animation(const JsonObject& json, std::size_t accessor_count,
                             std::size_t node_count) {
  GltfAnimation animation;
  animation.name = json.text("name");
  for (const JsonObject& sampler : json.objects("samplers")) {
    animation.samplers.push_back(read_sampler(sampler, accessor_count));
  }
  for (const JsonObject& channel : json.objects("channels")) {
    animation.channels.push_back(read_channel(channel, animation.samplers.size(), node_count));
  }
  return animation;
}

void require_version_2(const JsonObject& root) {
  if (!root.has("asset")) root.refuse("asset", "is missing: this is not a glTF file");
  const JsonObject asset = root.object("asset");
  const std::string version = asset.text("version");
  const std::string minimum = asset.text("minVersion");
  if (!version.starts_with("2.")) {
    asset.refuse_as_unsupported(
        "version", "Pelt reads glTF 2.0, this is " + text::quoted(version) + kExportGltf2);
  }
  if (!minimum.empty() && minimum != "2.0") {
    asset.refuse_as_unsupported(
        "minVersion", "Pelt reads glTF 2.0, this needs " + text::quoted(minimum) + kExportGltf2);
  }
}

/// Whether ignoring the extension does not change shapes and their motion.
bool is_known(const std::string& extension) {
  static constexpr std::string_view kShape[] = {kMeshopt, "KHR_mesh_quantization"};
  static constexpr std::string_view kLooks[] = {"KHR_texture_transform", "KHR_texture_basisu",
                                                "EXT_texture_webp",      "EXT_texture_avif",
                                                "KHR_lights_punctual",   "KHR_xmp_json_ld"};
  return std::find(std::begin(kShape), std::end(kShape), extension) != std::end(kShape) ||
         std::find(std::begin(kLooks), std::end(kLooks), extension) != std::end(kLooks) ||
         extension.starts_with("KHR_materials_");
}

std::vector<std::string> read_extensions(const JsonObject& root) {
  for (const std::string& extension : root.texts("extensionsRequired")) {
    if (is_known(extension)) continue;
    root.refuse_as_unsupported(
        "extensionsRequired",
        "Pelt does not support " + text::quoted(extension) + "; export the file without it");
  }
  std::vector<std::string> passed_over;
  for (const std::string& extension : root.texts("extensionsUsed")) {
    if (!is_known(extension)) passed_over.push_back(extension);
  }
  return passed_over;
}

void read_geometry(const JsonObject& root, GltfDocument& document) {
  const std::size_t buffer_count = root.array_size("buffers");
  const std::size_t view_count = root.array_size("bufferViews");
  const std::size_t accessor_count = root.array_size("accessors");
  const std::size_t material_count = root.array_size("materials");
  for (const JsonObject& json : root.objects("buffers")) {
    document.buffers.push_back(read_buffer(json));
  }
  for (const JsonObject& json : root.objects("bufferViews")) {
    document.views.push_back(read_view(json, buffer_count));
  }
  for (const JsonObject& json : root.objects("accessors")) {
    document.accessors.push_back(read_accessor(json, view_count));
  }
  for (const JsonObject& json : root.objects("materials")) {
    document.materials.push_back(json.text("name"));
  }
  for (const JsonObject& json : root.objects("meshes")) {
    document.meshes.push_back(read_mesh(json, accessor_count, material_count));
  }
}

void read_scene_graph(const JsonObject& root, GltfDocument& document) {
  const std::size_t node_count = root.array_size("nodes");
  const std::size_t accessor_count = root.array_size("accessors");
  for (const JsonObject& json : root.objects("nodes")) {
    document.nodes.push_back(read_node(json, root));
  }
  for (const JsonObject& json : root.objects("skins")) {
    document.skins.push_back(read_skin(json, node_count, accessor_count));
  }
  for (const JsonObject& json : root.objects("scenes")) {
    document.scenes.push_back(json.indices("nodes", node_count));
  }
  document.scene = root.optional_index("scene", root.array_size("scenes"));
  for (const JsonObject& json : root.objects("animations")) {
    document.animations.push_back(read_animation(json, accessor_count, node_count));
  }
}

}  // namespace

std::size_t GltfMesh::target_count() const {
  std::size_t count = 0;
  for (const GltfPrimitive& primitive : primitives)
    count = std::max(count, primitive.target_positions.size());
  return count;
}

std::size_t byte_size(ComponentType type) {
  if (type == ComponentType::i8 || type == ComponentType::u8) return 1;
  return type == ComponentType::i16 || type == ComponentType::u16 ? 2 : 4;
}

std::size_t component_count(ElementType type) {
  constexpr std::size_t kCounts[] = {1, 2, 3, 4, 4, 9, 16};
  return kCounts[static_cast<std::size_t>(type)];
}

const char* name(ElementType type) { return kElementTypes[static_cast<std::size_t>(type)].text; }

Result<GltfDocument> read_document(std::string_view text) {
  const Result<ParsedJson> json = parse_json(text);
  if (!json) return json.error();
  FirstError errors;
  const JsonObject root(**json, "", errors);
  GltfDocument document;
  require_version_2(root);
  document.passed_over_extensions = read_extensions(root);
  read_geometry(root, document);
  read_scene_graph(root, document);
  if (errors.get()) return *errors.get();
  return document;
}

}  // namespace pelt::asset
