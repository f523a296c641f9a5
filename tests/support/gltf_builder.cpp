#include "support/gltf_builder.hpp"

namespace pelt::test {

namespace {

std::string base64(const std::vector<std::byte>& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::size_t component_count(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "MAT4") return 16;
  return static_cast<std::size_t>(type.back() - '0');
}

void append(std::vector<std::byte>& bytes, const void* data, std::size_t size) {
  const auto* first = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

void append_u32(std::vector<std::byte>& bytes, std::size_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  append(bytes, &number, 4);
}

std::vector<std::byte> make_glb(std::string text, std::vector<std::byte> binary) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  std::vector<std::byte> file;
  append(file, "glTF", 4);
  append_u32(file, 2);
  append_u32(file, 12 + 8 + text.size() + 8 + binary.size());
  append_u32(file, text.size());
  append(file, "JSON", 4);
  append(file, text.data(), text.size());
  append_u32(file, binary.size());
  append(file, "BIN\0", 4);
  append(file, binary.data(), binary.size());
  return file;
}

std::size_t GltfBuilder::add(const char* array, const json& element) {
  document[array].push_back(element);
  return document[array].size() - 1;
}

std::size_t GltfBuilder::add_view(const void* data, std::size_t size) {
  binary.resize((binary.size() + 3) / 4 * 4);
  const std::size_t offset = binary.size();
  append(binary, data, size);
  return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
}

std::size_t GltfBuilder::add_accessor(std::size_t view, int component_type, const std::string& type,
                                      std::size_t count, bool normalised) {
  return add("accessors", {{"bufferView", view},
                           {"componentType", component_type},
                           {"normalized", normalised},
                           {"type", type},
                           {"count", count}});
}

std::size_t GltfBuilder::offset_of(std::size_t index) {
  const json& view = document["bufferViews"][accessor(index)["bufferView"].get<std::size_t>()];
  return view["byteOffset"].get<std::size_t>();
}

json& GltfBuilder::accessor(std::size_t index) { return document["accessors"][index]; }

json& GltfBuilder::primitive(std::size_t mesh, std::size_t index) {
  return document["meshes"][mesh]["primitives"][index];
}

json& GltfBuilder::attribute(const char* name) { return primitive()["attributes"][name]; }

std::vector<std::byte> GltfBuilder::glb() const {
  json whole = document;
  if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", binary.size()}}};
  return make_glb(whole.dump(), binary);
}

std::vector<std::byte> GltfBuilder::gltf(std::string uri) const {
  json whole = document;
  if (uri.empty()) uri = "data:application/octet-stream;base64," + base64(binary);
  whole["buffers"] = {{{"byteLength", binary.size()}, {"uri", uri}}};
  const std::string text = whole.dump();
  std::vector<std::byte> file;
  append(file, text.data(), text.size());
  return file;
}

Result<asset::Asset> GltfBuilder::load(const asset::GltfOptions& options) const {
  return asset::load_gltf(glb(), {}, options);
}

asset::Asset GltfBuilder::read(const asset::GltfOptions& options) const {
  Result<asset::Asset> asset = load(options);
  if (!asset) throw std::runtime_error("refused: " + asset.error().message);
  return *std::move(asset);
}

::testing::AssertionResult refused(const Result<asset::Asset>& result,
                                   std::initializer_list<std::string_view> words) {
  if (result) return ::testing::AssertionFailure() << "was not refused";
  const auto& [code, message] = result.error();
  const bool at_fault = code == ErrorCode::malformed_file || code == ErrorCode::unsupported;
  if (at_fault && message.find("export") == message.npos)
    return ::testing::AssertionFailure() << "no remedy in: " << message;
  for (const std::string_view word : words) {
    if (message.find(word) != message.npos) continue;
    return ::testing::AssertionFailure() << "no \"" << word << "\" in: " << message;
  }
  return ::testing::AssertionSuccess() << message;
}

GltfBuilder paper_strip() {
  GltfBuilder builder;
  std::vector<std::uint16_t> indices;
  for (std::uint16_t row = 0; row < 3; ++row) {
    const auto v = static_cast<std::uint16_t>(2 * row);
    for (const int corner : {0, 1, 2, 2, 1, 3}) {
      indices.push_back(static_cast<std::uint16_t>(v + corner));
    }
  }
  std::vector<float> positions, weights;
  std::vector<std::uint8_t> joints;
  for (int v = 0; v < 8; ++v) {
    const float y = static_cast<float>(v / 2);
    positions.insert(positions.end(), {static_cast<float>(v % 2), y, 0});
    joints.insert(joints.end(), {0, 1, 0, 0});
    weights.insert(weights.end(), {1 - y / 4, y / 4, 0, 0});
  }
  const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,     0, 1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.5f, 0, 1};
  builder.add_accessor(indices, "SCALAR");
  builder.add_accessor(positions, "VEC3");
  builder.add_accessor(joints, "VEC4");
  builder.add_accessor(weights, "VEC4");
  builder.add_accessor(matrices, "MAT4");
  builder.add_accessor(std::vector<float>{0, 1}, "SCALAR");
  builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0.6f, 0.8f}, "VEC4");
  const json attributes = {{"POSITION", 1}, {"JOINTS_0", 2}, {"WEIGHTS_0", 3}};
  const json primitive = {{"attributes", attributes}, {"indices", 0}};
  builder.add("meshes", {{"name", "sheet"}, {"primitives", {primitive}}});
  builder.add("nodes", {{"name", "paper"}, {"mesh", 0}, {"skin", 0}});
  builder.add("nodes", {{"name", "lower"}, {"children", {2}}});
  builder.add("nodes", {{"name", "upper"}, {"translation", {0, 1.5, 0}}});
  builder.add("skins", {{"name", "rig"}, {"joints", {1, 2}}, {"inverseBindMatrices", 4}});
  builder.add("scenes", {{"nodes", {0, 1}}});
  const json channel = {{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}};
  const json sampler = {{"input", 5}, {"output", 6}};
  builder.add("animations", {{"name", "bend"}, {"channels", {channel}}, {"samplers", {sampler}}});
  return builder;
}

GltfBuilder stone() {
  GltfBuilder builder;
  builder.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  builder.add("meshes", {{"name", "rock"}, {"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  builder.add("nodes", {{"name", "stone"}, {"mesh", 0}});
  builder.add("scenes", {{"nodes", {0}}});
  return builder;
}

}  // namespace pelt::test
