#include "tools/pelt/page/geometry_copy.hpp"

#include "asset/file_bytes.hpp"
#include "asset/read_gltf.hpp"
#include "support/gltf_builder.hpp"
#include "support/gltf_corpus.hpp"

#include <pelt/pelt.hpp>

namespace pelt::tools::page {
namespace {

namespace fs = std::filesystem;

using test::GltfBuilder;
using test::json;

void expect_same(const asset::Clip& a, const asset::Clip& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.duration, b.duration);
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    EXPECT_EQ(a.channels[c].node, b.channels[c].node);
    EXPECT_EQ(a.channels[c].path, b.channels[c].path);
    EXPECT_EQ(a.channels[c].interpolation, b.channels[c].interpolation);
    EXPECT_EQ(a.channels[c].times, b.channels[c].times);
    EXPECT_EQ(a.channels[c].values, b.channels[c].values);
  }
}

void expect_same_structure(const asset::Asset& a, const asset::Asset& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    EXPECT_EQ(a.nodes[n].name, b.nodes[n].name);
    EXPECT_EQ(a.nodes[n].parent, b.nodes[n].parent);
    EXPECT_EQ(a.nodes[n].local.translation, b.nodes[n].local.translation);
    EXPECT_EQ(a.nodes[n].local.rotation, b.nodes[n].local.rotation);
    EXPECT_EQ(a.nodes[n].local.scale, b.nodes[n].local.scale);
    EXPECT_EQ(a.nodes[n].has_matrix, b.nodes[n].has_matrix);
    EXPECT_EQ(a.nodes[n].matrix, b.nodes[n].matrix);
  }
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t j = 0; j < a.joints.size(); ++j) {
    EXPECT_EQ(a.joints[j].node, b.joints[j].node);
    EXPECT_EQ(a.joints[j].inverse_bind, b.joints[j].inverse_bind);
  }
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t p = 0; p < a.parts.size(); ++p) {
    EXPECT_EQ(a.parts[p].node, b.parts[p].node);
    EXPECT_EQ(a.parts[p].mesh, b.parts[p].mesh);
    EXPECT_EQ(a.parts[p].material, b.parts[p].material);
    EXPECT_EQ(a.parts[p].triangle_count, b.parts[p].triangle_count);
    EXPECT_EQ(a.parts[p].skinned, b.parts[p].skinned);
  }
}

void expect_same(const asset::Asset& a, const asset::Asset& b) {
  EXPECT_EQ(a.rest_positions, b.rest_positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.influences_per_vertex, b.influences_per_vertex);
  EXPECT_EQ(a.joint_indices, b.joint_indices);
  EXPECT_EQ(a.weights, b.weights);
  EXPECT_EQ(a.morph_begin, b.morph_begin);
  EXPECT_EQ(a.morph_vertices, b.morph_vertices);
  EXPECT_EQ(a.morph_displacements, b.morph_displacements);
  ASSERT_EQ(a.morph_targets.size(), b.morph_targets.size());
  for (std::size_t m = 0; m < a.morph_targets.size(); ++m) {
    EXPECT_EQ(a.morph_targets[m].name, b.morph_targets[m].name);
    EXPECT_EQ(a.morph_targets[m].node, b.morph_targets[m].node);
    EXPECT_EQ(a.morph_targets[m].default_weight, b.morph_targets[m].default_weight);
  }
  expect_same_structure(a, b);
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (std::size_t c = 0; c < a.clips.size(); ++c) expect_same(a.clips[c], b.clips[c]);
  EXPECT_EQ(a.warnings, b.warnings);
}

/// Returns the copy of a file after comparing what Pelt reads from both.
std::vector<std::byte> copy_of(const std::vector<std::byte>& file, const fs::path& folder,
                               const asset::GltfOptions& options = {}) {
  const auto original = asset::read_gltf(file, folder, options);
  EXPECT_TRUE(original) << original.error().message;
  if (!original) return {};
  const auto copy = copy_geometry(file, folder, original->views);
  EXPECT_TRUE(copy) << copy.error().message;
  if (!copy) return {};
  const auto read = asset::read_gltf(*copy, {}, options);
  EXPECT_TRUE(read) << read.error().message;
  if (read) expect_same(original->asset, read->asset);
  return *copy;
}

json document_of(const std::vector<std::byte>& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, &glb.at(12), sizeof length);
  const auto* text = reinterpret_cast<const char*>(&glb.at(20));
  return json::parse(text, text + length);
}

TEST(GeometryCopy, HasTheAssetOfEveryFeature) {
  std::size_t compressed = 0, sparse = 0;
  for (const test::GltfSeed& seed : test::gltf_corpus()) {
    SCOPED_TRACE(seed.name);
    compressed += seed.json.find("EXT_meshopt") != std::string::npos;
    sparse += seed.json.find("sparse") != std::string::npos;
    copy_of(test::make_glb(seed.json, seed.binary), {});
  }
  EXPECT_GT(compressed, 0u);
  EXPECT_GT(sparse, 0u);
}

TEST(GeometryCopy, HasTheAssetOfRealCharacters) {
  const fs::path models = fs::path(PELT_SHARED_DIR) / "models";
  if (!fs::exists(models)) GTEST_SKIP() << models << " is not there";
  std::size_t copied = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(models)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".glb" && path.extension() != ".gltf") continue;
    SCOPED_TRACE(path);
    const auto file = asset::read_file(path);
    ASSERT_TRUE(file);
    EXPECT_LT(copy_of(*file, models).size(), file->size() + 1000);
    ++copied;
  }
  EXPECT_GT(copied, 10u);
}

/// 100 kB each of an image in the binary chunk, a data URI, extras, and normals.
GltfBuilder strip_with_looks() {
  constexpr std::size_t kSize = 100'000;
  GltfBuilder builder = test::paper_strip();
  const std::vector<std::byte> pixels(kSize);
  builder.document["images"] = {{{"bufferView", builder.add_view(pixels)}},
                                {{"uri", "data:image/png;base64," + std::string(kSize, 'A')}}};
  builder.document["textures"] = {{{"source", 0}}};
  builder.document["materials"] = {
      {{"name", "kraft"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  builder.primitive()["material"] = 0;
  builder.primitive()["attributes"]["NORMAL"] =
      builder.add_accessor(std::vector<float>(kSize / 4 / 3 * 3), "VEC3");
  builder.document["meshes"][0]["extras"] = {{"note", std::string(kSize, 'x')}};
  builder.document["extras"] = std::string(kSize, 'x');
  return builder;
}

TEST(GeometryCopy, LeavesOutWhatPeltDoesNotRead) {
  const GltfBuilder builder = strip_with_looks();
  const std::size_t plain = test::paper_strip().glb().size();
  for (const std::vector<std::byte>& file : {builder.glb(), builder.gltf()}) {
    ASSERT_GT(file.size(), 500'000u);
    const std::vector<std::byte> copy = copy_of(file, {});
    EXPECT_LT(copy.size(), plain + 500);
    const json document = document_of(copy);
    EXPECT_EQ(document["materials"], json::array({{{"name", "kraft"}}}));
    EXPECT_FALSE(document["meshes"][0]["primitives"][0]["attributes"].contains("NORMAL"));
  }
}

TEST(GeometryCopy, StoresViewsOfTheSameBytesOnce) {
  GltfBuilder builder = test::paper_strip();
  const std::vector<float> weights(3 * 30000, 1);
  const std::size_t first = builder.add_accessor(weights, "VEC3");
  json second = builder.accessor(first);
  second["bufferView"] = builder.add("bufferViews", json(builder.document["bufferViews"].back()));
  for (const std::size_t position : {first, builder.add("accessors", second)}) {
    builder.document["scenes"][0]["nodes"].push_back(
        builder.add("nodes", {{"mesh", builder.document["meshes"].size()}}));
    builder.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", position}}}}}}});
  }
  EXPECT_LT(copy_of(builder.glb(), {}).size(), 400'000u);
}

/// The mesh of the node is read only without the option.
TEST(GeometryCopy, HasOnlyTheViewsThatWereRead) {
  GltfBuilder both = test::paper_strip();
  const std::size_t position = both.add_accessor(std::vector<float>(3 * 30000, 1), "VEC3");
  both.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", position}}}}}}});
  both.document["scenes"][0]["nodes"].push_back(
      both.add("nodes", {{"name", "rubble"}, {"mesh", 1}}));
  asset::GltfOptions options;
  EXPECT_GT(copy_of(both.glb(), {}, options).size(), 300'000u);
  options.exclude_nodes = {"rubble"};
  EXPECT_LT(copy_of(both.glb(), {}, options).size(), 10'000u);
}

}  // namespace
}  // namespace pelt::tools::page
