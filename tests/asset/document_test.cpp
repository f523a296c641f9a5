#include "asset/document.hpp"

#include "asset/container.hpp"
#include "asset/json_object.hpp"
#include "asset/parsed_json.hpp"
#include "support/gltf_builder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

Result<Asset> load_text(const std::string& text) {
  return load_gltf(std::as_bytes(std::span(text)), {});
}

TEST(Json, RefusesWhatIsNoJson) {
  EXPECT_NE(parse_json(" \n").error().message.find("the JSON text is empty"), std::string::npos);
  EXPECT_TRUE(refused(load_text("{\"asset\": "), {"JSON", "line 1"}));
  EXPECT_TRUE(refused(load_text("solid cube"), {"JSON"}));
  EXPECT_TRUE(refused(load_text("{\"asset\": {\"version\": \"\xFF\"}}"), {"JSON"}));
  EXPECT_TRUE(refused(load_text("[1, 2]"), {"JSON", "object"}));
}

TEST(Json, RefusesDeepNestingBeforeItIsParsed) {
  const std::size_t kDeep = 1000000;
  EXPECT_TRUE(refused(load_text("{\"a\":" + std::string(kDeep, '[')), {"nested"}));
  const std::string whole = std::string(kDeep, '[') + std::string(kDeep, ']');
  EXPECT_TRUE(refused(load_text("{\"extras\":" + whole + "}"), {"nested more than 64 deep"}));
}

TEST(Json, BracketsInStringsAreNoNesting) {
  GltfBuilder builder = test::stone();
  builder.document["nodes"][0]["name"] = std::string(100, '[') + "\\\"" + std::string(100, '{');
  EXPECT_TRUE(builder.load());
}

TEST(Json, CutsWhatItQuotes) {
  const Result<Asset> asset = load_text("{\"a\": " + std::string(100000, 'x'));
  ASSERT_FALSE(asset);
  EXPECT_LT(asset.error().message.size(), 400u);
}

TEST(JsonObject, ReadsWholeNumbersHoweverTheyAreWritten) {
  const json values = {{"plain", 7},    {"point", 7.0}, {"negative", -1},    {"half", 0.5},
                       {"huge", 1e300}, {"text", "7"},  {"most", UINT64_MAX}};
  FirstError errors;
  const JsonObject object(values, "things[3]", errors);
  EXPECT_EQ(object.count("plain"), 7u);
  EXPECT_EQ(object.count("point"), 7u);
  EXPECT_EQ(object.count("most"), UINT64_MAX);
  EXPECT_EQ(object.count("none", 5), 5u);
  EXPECT_FALSE(errors.get());
  for (const char* key : {"negative", "half", "huge", "text", "none"}) {
    FirstError error;
    JsonObject(values, "things[3]", error).count(key);
    ASSERT_TRUE(error.get()) << key;
    EXPECT_TRUE(error.get()->message.starts_with(std::string("things[3].") + key))
        << error.get()->message;
  }
}

TEST(JsonObject, KeepsTheFirstError) {
  const json values = {{"a", 1}};
  FirstError errors;
  const JsonObject object(values, "", errors);
  object.text("a");
  object.flag("a");
  ASSERT_TRUE(errors.get());
  EXPECT_EQ(errors.get()->message, "a: must be a string");
}

/// Sets one value of the strip's document and loads the file.
Result<Asset> load_with(const char* pointer, const json& value) {
  GltfBuilder builder = test::paper_strip();
  builder.document["buffers"] = {{{"byteLength", builder.binary.size()}}};
  builder.document[json::json_pointer(pointer)] = value;
  return builder.load();
}

TEST(Document, NamesTheFieldThatHasTheWrongType) {
  const json number = 3, text = "three", list = json::array({1}), object = json::object();
  struct {
    const char* pointer;
    json value;
    const char* path;
  } const kCases[] = {
      {"/asset", number, "asset: must be an object"},
      {"/asset/version", number, "asset.version: must be a string"},
      {"/buffers", object, "buffers: must be an array"},
      {"/buffers/0/uri", number, "buffers[0].uri: must be a string"},
      {"/buffers/0/byteLength", -1, "buffers[0].byteLength: must be a whole number"},
      {"/bufferViews/1", number, "bufferViews[1]: must be an object"},
      {"/bufferViews/1/byteOffset", text, "bufferViews[1].byteOffset: must be a whole number"},
      {"/bufferViews/1/byteStride", 256, "bufferViews[1].byteStride: must be at most 252"},
      {"/accessors/2/componentType", 5124, "accessors[2].componentType"},
      {"/accessors/2/type", "VEC5", "accessors[2].type: unknown value \"VEC5\""},
      {"/accessors/2/normalized", number, "accessors[2].normalized: must be true or false"},
      {"/accessors/2/count", 1.5, "accessors[2].count: must be a whole number"},
      {"/accessors/2/sparse", list, "accessors[2].sparse: must be an object"},
      {"/meshes/0/name", list, "meshes[0].name: must be a string"},
      {"/meshes/0/weights", json::array({"x"}), "meshes[0].weights[0]: must be a number"},
      {"/meshes/0/weights", json::array({1e39}), "meshes[0].weights[0]: must be a number"},
      {"/meshes/0/primitives/0/mode", 7, "meshes[0].primitives[0].mode: must be 0 to 6"},
      {"/meshes/0/primitives/0/attributes", list, "primitives[0].attributes: must be an object"},
      {"/nodes/1/children", json::array({-1}), "nodes[1].children[0]: must be a whole number"},
      {"/nodes/1/matrix", list, "nodes[1].matrix: must have 16 numbers"},
      {"/nodes/1/translation", text, "nodes[1].translation: must be an array"},
      {"/nodes/1/scale", json::array({1, 2, nullptr}), "nodes[1].scale[2]: must be a number"},
      {"/nodes/1/rotation", json::array({0, 0, 0, 0}), "nodes[1].rotation: must be a unit"},
      {"/nodes/1/rotation", json::array({0, 0, 0, 2}), "nodes[1].rotation: must be a unit"},
      {"/skins/0/joints", json::array(), "skins[0].joints: must have at least one joint"},
      {"/animations/0/samplers/0/interpolation", "FAST", "interpolation: unknown value \"FAST\""},
      {"/extensionsRequired", number, "extensionsRequired: must be an array"},
      {"/extensionsRequired", list, "extensionsRequired[0]: must be a string"},
  };
  for (const auto& c : kCases) {
    EXPECT_TRUE(refused(load_with(c.pointer, c.value), {c.path})) << c.pointer;
  }
}

TEST(Document, NamesTheIndexThatPointsNowhere) {
  struct {
    const char* pointer;
    json value;
    const char* path;
  } const kCases[] = {
      {"/bufferViews/1/buffer", 1, "bufferViews[1].buffer: must be a whole number below 1"},
      {"/accessors/2/bufferView", 7, "accessors[2].bufferView: must be a whole number below 7"},
      {"/meshes/0/primitives/0/indices", 7, "primitives[0].indices"},
      {"/meshes/0/primitives/0/material", 0, "primitives[0].material"},
      {"/meshes/0/primitives/0/attributes/POSITION", 7, "attributes.POSITION"},
      {"/meshes/0/primitives/0/attributes/JOINTS_0", 7, "attributes.JOINTS_0"},
      {"/meshes/0/primitives/0/targets", json::array({{{"POSITION", 7}}}), "targets[0].POSITION"},
      {"/nodes/0/mesh", 1, "nodes[0].mesh"},
      {"/nodes/0/skin", 1, "nodes[0].skin"},
      {"/nodes/1/children", json::array({3}), "nodes[1].children[0]"},
      {"/skins/0/joints", json::array({1, 4294967297}), "skins[0].joints[1]"},
      {"/skins/0/inverseBindMatrices", 7, "skins[0].inverseBindMatrices"},
      {"/scenes/0/nodes", json::array({0, 3}), "scenes[0].nodes[1]"},
      {"/scene", 1, "scene: must be a whole number below 1"},
      {"/animations/0/samplers/0/input", 7, "animations[0].samplers[0].input"},
      {"/animations/0/samplers/0/output", 7, "animations[0].samplers[0].output"},
      {"/animations/0/channels/0/sampler", 1, "animations[0].channels[0].sampler"},
      {"/animations/0/channels/0/target/node", 3, "channels[0].target.node"},
  };
  for (const auto& c : kCases) {
    EXPECT_TRUE(refused(load_with(c.pointer, c.value), {c.path, "number"})) << c.pointer;
  }
}

TEST(Document, NamesTheFieldThatIsMissing) {
  struct {
    const char* object;
    const char* key;
  } const kCases[] = {{"/buffers/0", "byteLength"},
                      {"/bufferViews/1", "buffer"},
                      {"/bufferViews/1", "byteLength"},
                      {"/accessors/1", "componentType"},
                      {"/accessors/1", "count"},
                      {"/accessors/1", "type"},
                      {"/animations/0/samplers/0", "input"},
                      {"/animations/0/channels/0", "sampler"}};
  for (const auto& c : kCases) {
    GltfBuilder builder = test::paper_strip();
    builder.document["buffers"] = {{{"byteLength", builder.binary.size()}}};
    builder.document[json::json_pointer(c.object)].erase(c.key);
    EXPECT_TRUE(refused(builder.load(), {std::string(c.key) + ": is missing"})) << c.object;
  }
}

TEST(Document, RefusesWhatSaysNothingOfGltf) {
  EXPECT_TRUE(refused(load_text("{}"), {"asset: is missing", "not a glTF file"}));
}

TEST(Document, RefusesOtherVersionsOfTheFormat) {
  EXPECT_TRUE(refused(load_with("/asset/version", "1.0"), {"asset.version", "\"1.0\""}));
  EXPECT_TRUE(refused(load_with("/asset/minVersion", "2.1"), {"asset.minVersion", "\"2.1\""}));
  EXPECT_TRUE(load_with("/asset/version", "2.1"));
  EXPECT_TRUE(load_with("/asset/minVersion", "2.0"));
  EXPECT_EQ(load_with("/asset/version", "1.0").error().code, ErrorCode::unsupported);
}

TEST(Document, RefusesRequiredExtensionsByName) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_mesh_gpu_instancing", "X\nY"}) {
    const Result<Asset> asset = load_with("/extensionsRequired", json::array({name}));
    ASSERT_FALSE(asset);
    EXPECT_EQ(asset.error().code, ErrorCode::unsupported);
    EXPECT_NE(asset.error().message.find(name[0] == 'X' ? "\"X?Y\"" : name), std::string::npos);
  }
}

TEST(Document, AcceptsRequiredExtensionsThatDoNotAffectShapes) {
  EXPECT_TRUE(load_with("/extensionsRequired", {"KHR_mesh_quantization", "EXT_meshopt_compression",
                                                "KHR_materials_unlit", "KHR_texture_transform"}));
}

TEST(Document, WarnsOfExtensionsThatItPassesOver) {
  const Result<Asset> asset = load_with("/extensionsUsed", {"KHR_materials_unlit", "EXT_novelty"});
  ASSERT_TRUE(asset);
  EXPECT_EQ(asset->warnings, std::vector<std::string>{"extension \"EXT_novelty\" is ignored"});
}

TEST(Document, RefusesSetsOfInfluencesWithGaps) {
  GltfBuilder builder = test::paper_strip();
  builder.attribute("JOINTS_1") = 2;
  EXPECT_TRUE(refused(builder.load(), {"attributes.WEIGHTS_1: is missing"}));
  builder = test::paper_strip();
  builder.attribute("JOINTS_2") = 2;
  builder.attribute("WEIGHTS_2") = 3;
  EXPECT_TRUE(refused(builder.load(), {"attributes.JOINTS_1: is missing"}));
  builder = test::paper_strip();
  builder.primitive()["attributes"].erase("JOINTS_0");
  EXPECT_TRUE(refused(builder.load(), {"attributes.JOINTS_0: is missing"}));
}

TEST(ParsedJson, IsTheTreeOfTheParser) {
  for (const std::string text :
       {"null", "true", "-7", "18446744073709551615", "0.25", R"("a\u00e9\n")", "[]", "{}",
        R"([1, [2, [3, {}], []], {"a": [null, {"b": "c"}], "": {"d": -1.5e-3}}, false])",
        R"( {"a": {"b": {"c": [[[]]]}}, "z": [{"a": 1}, {"a": 2}]} )"}) {
    const Result<ParsedJson> parsed = parse_json(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(**parsed, json::parse(text)) << text;
  }
}

TEST(ParsedJson, UsesTheLastOfEqualKeys) {
  for (const std::string text :
       {R"({"a": 1, "a": 2})", R"({"a": [[1], [2]], "b": 3, "a": {"c": [4]}})",
        R"({"a": {"a": [1, {"a": 2}]}, "a": []})"}) {
    const Result<ParsedJson> parsed = parse_json(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(**parsed, json::parse(text)) << text;
  }
}

TEST(ParsedJson, RefusesWhatIsNotWhole) {
  for (const std::string text : {"", " \n", "{", "[1,]", "[1] 2", "{\"a\" 1}", "1e999", "nul", "[1",
                                 "{\"a\":[{}", "\"\xff\"", "[1]]"}) {
    const Result<ParsedJson> parsed = parse_json(text);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.error().code, ErrorCode::malformed_file);
    EXPECT_NE(parsed.error().message.find("the JSON text is "), std::string::npos);
  }
}

using test::append;
using test::append_u32;

Result<Asset> load(const std::vector<std::byte>& file) { return load_gltf(file, {}); }

void set_u32(std::vector<std::byte>& file, std::size_t offset, std::uint32_t value) {
  std::memcpy(&file[offset], &value, 4);
}

TEST(Container, GlbAndGltfGiveTheSame) {
  const Result<Asset> glb = load(test::paper_strip().glb());
  const Result<Asset> gltf = load(test::paper_strip().gltf());
  ASSERT_TRUE(glb) << glb.error().message;
  ASSERT_TRUE(gltf) << gltf.error().message;
  EXPECT_EQ(glb->rest_positions, gltf->rest_positions);
  EXPECT_EQ(glb->triangles, gltf->triangles);
  EXPECT_EQ(glb->weights, gltf->weights);
}

TEST(Container, ChecksABeginningLikeTheWholeFile) {
  for (const std::string text :
       {"", "{", " \r\n\t", "\xEF\xBB\xBF", "glTF", "\xEF\xBB\xBF {", "glTF\x02"})
    EXPECT_TRUE(check_beginning(std::as_bytes(std::span(text)))) << text;
  for (const std::string text : {"solid", "glTX", "[1]", "  x", "g"}) {
    const Result<void> checked = check_beginning(std::as_bytes(std::span(text)));
    ASSERT_FALSE(checked) << text;
    const Result<Container> opened = open_container(std::as_bytes(std::span(text)));
    ASSERT_FALSE(opened) << text;
    EXPECT_EQ(checked.error().message, opened.error().message);
  }
}

TEST(Container, PassesOverUnknownChunksAndWhatFollowsTheFile) {
  std::vector<std::byte> file = test::paper_strip().glb();
  append_u32(file, 4);
  append(file, "MORE", 4);
  append(file, "1234", 4);
  set_u32(file, 8, static_cast<std::uint32_t>(file.size()));
  append(file, "tail", 4);
  const Result<Container> container = open_container(file);
  ASSERT_TRUE(container);
  EXPECT_TRUE(container->binary.has_value());
  EXPECT_TRUE(load(file));
}

TEST(Container, SaysThatAFileIsEmpty) { EXPECT_TRUE(refused(load({}), {"the file is empty"})); }

TEST(Container, RefusesOtherVersions) {
  std::vector<std::byte> file = test::stone().glb();
  set_u32(file, 4, 1);
  EXPECT_TRUE(refused(load(file), {"version 1"}));
  EXPECT_EQ(load(file).error().code, ErrorCode::unsupported);
}

TEST(Container, RefusesALengthBeyondTheFile) {
  std::vector<std::byte> file = test::stone().glb();
  set_u32(file, 8, static_cast<std::uint32_t>(file.size() + 1));
  EXPECT_TRUE(refused(load(file), {"says that it has"}));
  set_u32(file, 8, 11);
  EXPECT_TRUE(refused(load(file), {"says that it has 11 bytes"}));
}

TEST(Container, RefusesAChunkBeyondTheFile) {
  std::vector<std::byte> file = test::stone().glb();
  set_u32(file, 12, 0xFFFFFFFF);
  EXPECT_TRUE(refused(load(file), {"truncated", "4294967295"}));
}

TEST(Container, RefusesAFirstChunkThatIsNotJson) {
  std::vector<std::byte> file = test::stone().glb();
  set_u32(file, 16, 0x004E4942);
  EXPECT_TRUE(refused(load(file), {"first chunk"}));
}

TEST(Container, RefusesEveryTruncation) {
  const std::vector<std::byte> file = test::paper_strip().glb();
  for (std::size_t size = 0; size < file.size(); ++size) {
    const std::span<const std::byte> cut(file.data(), size);
    EXPECT_FALSE(load_gltf(cut, {})) << size;
  }
}

TEST(Container, NamesAHeaderThatIsCut) {
  const std::vector<std::byte> file = test::stone().glb();
  EXPECT_TRUE(refused(load({file.begin(), file.begin() + 8}), {"ends inside its header"}));
  std::vector<std::byte> chunk(file.begin(), file.begin() + 16);
  set_u32(chunk, 8, 16);
  EXPECT_TRUE(refused(load(chunk), {"ends inside the header of a chunk"}));
}

}  // namespace
}  // namespace pelt::asset
