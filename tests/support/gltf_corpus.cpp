#include "support/gltf_corpus.hpp"

#include "support/gltf_builder.hpp"

#include <meshoptimizer.h>

namespace pelt::test {

namespace {

GltfSeed seed_of(const char* name, const GltfBuilder& builder) {
  json document = builder.document;
  if (!document.contains("buffers"))
    document["buffers"] = {{{"byteLength", builder.binary.size()}}};
  return {name, document.dump(), builder.binary};
}

/// Sparse positions, morph targets with default weights, and a channel that animates them.
GltfBuilder morphing() {
  GltfBuilder builder = paper_strip();
  const std::size_t indices = builder.add_view(std::vector<std::uint8_t>{1, 3, 6});
  const std::size_t values = builder.add_view(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  const json sparse = {{"count", 3},
                       {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                       {"values", {{"bufferView", values}}}};
  const std::size_t target = builder.add(
      "accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 8}, {"sparse", sparse}});
  builder.accessor(1)["sparse"] = sparse;
  builder.primitive()["targets"] = json::array({{{"POSITION", target}}, {{"POSITION", 1}}});
  builder.document["meshes"][0]["weights"] = {0.5, 0.25};
  const std::size_t weights = builder.add_accessor(std::vector<float>{0, 1, 0.5f, -1}, "SCALAR");
  builder.document["animations"][0]["samplers"].push_back({{"input", 5}, {"output", weights}});
  const json channel = {{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}};
  builder.document["animations"][0]["channels"].push_back(channel);
  return builder;
}

/// Two skins, an unskinned mesh in two nodes, strips and fans, points, a matrix, two sets of
/// influences, a spline, a second scene.
GltfBuilder crowded() {
  GltfBuilder builder = paper_strip();
  const std::size_t stone =
      builder.add_accessor(std::vector<std::int16_t>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
  json primitives = json::array();
  for (const int mode : {0, 5, 6}) {
    primitives.push_back({{"attributes", {{"POSITION", stone}}}, {"mode", mode}, {"material", 0}});
  }
  builder.add("materials", {{"name", "granite"}});
  builder.add("meshes", {{"name", "rock"}, {"primitives", primitives}});
  std::vector<std::uint8_t> fifths;
  for (int v = 0; v < 8; ++v) fifths.insert(fifths.end(), {51, 51, 0, 0});
  builder.attribute("WEIGHTS_0") = builder.add_accessor(fifths, "VEC4", true);
  builder.attribute("JOINTS_1") = 2;
  builder.attribute("WEIGHTS_1") = builder.add_accessor(std::vector<float>(32, 0.15f), "VEC4");
  builder.add("skins", {{"joints", {2, 1}}});
  builder.add("nodes", {{"mesh", 1}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}});
  builder.add("nodes", {{"mesh", 0}, {"skin", 1}, {"scale", {1, 2, 3}}, {"children", {5}}});
  builder.add("nodes", {{"mesh", 1}, {"rotation", {0, 0, 0.6, 0.8}}});
  builder.document["scenes"][0]["nodes"] = {0, 1, 3, 4};
  builder.add("scenes", {{"nodes", {3}}});
  const std::size_t spline = builder.add_accessor(std::vector<float>(18, 0.5f), "VEC3");
  json& animation = builder.document["animations"][0];
  animation["samplers"].push_back(
      {{"input", 5}, {"output", spline}, {"interpolation", "CUBICSPLINE"}});
  animation["channels"].push_back(
      {{"sampler", 1}, {"target", {{"node", 1}, {"path", "translation"}}}});
  return builder;
}

void compress(GltfBuilder& builder, std::size_t view, std::size_t stride) {
  json& target = builder.document["bufferViews"][view];
  const std::size_t offset = target["byteOffset"].get<std::size_t>();
  const std::size_t count = target["byteLength"].get<std::size_t>() / stride;
  std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), &builder.binary[offset],
                                           count, stride));
  target["buffer"] = 1;
  target["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                     {"byteOffset", builder.binary.size()},
                                                     {"byteLength", packed.size()},
                                                     {"byteStride", stride},
                                                     {"count", count},
                                                     {"mode", "ATTRIBUTES"}};
  append(builder.binary, packed.data(), packed.size());
}

GltfBuilder compressed() {
  GltfBuilder builder = paper_strip();
  std::vector<std::uint32_t> indices(18);
  for (std::uint32_t i = 0; i < 18; ++i) indices[i] = i % 8;
  std::vector<unsigned char> packed(1024);
  packed.resize(
      meshopt_encodeIndexSequence(packed.data(), packed.size(), indices.data(), indices.size()));
  json& view = builder.document["bufferViews"][0];
  view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                   {"byteOffset", builder.binary.size()},
                                                   {"byteLength", packed.size()},
                                                   {"byteStride", 2},
                                                   {"count", 18},
                                                   {"mode", "INDICES"}};
  append(builder.binary, packed.data(), packed.size());
  compress(builder, 1, 12);
  compress(builder, 2, 4);
  compress(builder, 6, 16);
  const json fallback = {{"byteLength", 4096},
                         {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}};
  builder.document["buffers"] = json::array({{{"byteLength", builder.binary.size()}}, fallback});
  builder.document["extensionsRequired"] = {"EXT_meshopt_compression"};
  return builder;
}

GltfSeed data_uris() {
  const std::vector<std::byte> file = paper_strip().gltf();
  return {"data_uris", {reinterpret_cast<const char*>(file.data()), file.size()}, {}};
}

}  // namespace

std::vector<GltfSeed> gltf_corpus() {
  return {seed_of("strip", paper_strip()),     seed_of("stone", stone()),
          seed_of("morphing", morphing()),     seed_of("crowded", crowded()),
          seed_of("compressed", compressed()), data_uris()};
}

}  // namespace pelt::test
