#include "asset/container.hpp"

#include "support/gltf_builder.hpp"

namespace pelt::asset {
namespace {

using test::append;
using test::append_u32;
using test::make_glb;
using test::refused;

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
