#include "asset/buffers.hpp"
#include "asset/budget.hpp"
#include "asset/parsed_json.hpp"
#include "asset/uri.hpp"
#include "support/gltf_builder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace pelt::asset {
namespace {

namespace fs = std::filesystem;
using test::GltfBuilder;
using test::refused;

/// A path for the files of the running test.
fs::path folder_of_test(const std::string& topic) {
  return fs::path(::testing::TempDir()) /
         ("pelt-" + topic + "-" + ::testing::UnitTest::GetInstance()->current_test_info()->name());
}

/// A folder with a .gltf file and its buffer.
class BesideFiles : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "data"); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::vector<std::byte>& bytes) const {
    std::ofstream stream(folder_ / name, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  }

  Result<Asset> load(const std::string& uri) const {
    write("model.gltf", test::paper_strip().gltf(uri));
    return load_gltf(folder_ / "model.gltf");
  }

  fs::path folder_ = folder_of_test("buffers");
};

TEST_F(BesideFiles, AreRead) {
  write("data/the bytes.bin", test::paper_strip().binary);
  const Result<Asset> asset = load("data/the%20bytes.bin");
  ASSERT_TRUE(asset) << asset.error().message;
  EXPECT_EQ(asset->rest_positions, test::paper_strip().load()->rest_positions);
}

TEST_F(BesideFiles, AreNamedWhenTheyAreMissing) {
  const Result<Asset> asset = load("none.bin");
  EXPECT_TRUE(refused(asset, {"model.gltf", "accessor 1", "buffer 0", "none.bin", "no such file"}));
  EXPECT_EQ(asset.error().code, ErrorCode::unreadable_file);
}

TEST_F(BesideFiles, MustHaveTheBytesThatTheFileSays) {
  write("short.bin", std::vector<std::byte>(10));
  EXPECT_TRUE(refused(load("short.bin"), {"buffer 0", "byteLength", "only 10 bytes"}));
}

TEST_F(BesideFiles, MustBeRegularFiles) {
  EXPECT_TRUE(refused(load("data"), {"is not a regular file"}));
}

TEST_F(BesideFiles, MayNotLieOutside) {
  EXPECT_TRUE(refused(load("../model.bin"), {"buffer 0", "\"../model.bin\""}));
}

TEST_F(BesideFiles, OneFileBehindManyBuffersIsReadOnce) {
  GltfBuilder builder = test::paper_strip();
  write("model.bin", builder.binary);
  for (std::size_t i = 0; i < builder.document["bufferViews"].size(); ++i) {
    builder.document["bufferViews"][i]["buffer"] = i;
    builder.add("buffers", {{"byteLength", builder.binary.size()}, {"uri", "model.bin"}});
  }
  const std::string text = builder.document.dump();
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  const Result<Asset> asset = load_gltf(std::span(bytes, text.size()), folder_);
  EXPECT_TRUE(asset) << asset.error().message;
}

TEST(LoadGltf, NamesAFileThatIsMissing) {
  const Result<Asset> asset = load_gltf(fs::path("no/such/model.glb"));
  EXPECT_TRUE(refused(asset, {"no/such/model.glb", "there is no such file"}));
  EXPECT_EQ(asset.error().code, ErrorCode::unreadable_file);
}

TEST(LoadGltf, NamesAFolder) {
  EXPECT_TRUE(refused(load_gltf(fs::path(".")), {"is not a regular file"}));
}

TEST(Buffers, RefusesExternalFilesWithoutAFolder) {
  const std::vector<std::byte> file = test::paper_strip().gltf("model.bin");
  EXPECT_TRUE(refused(load_gltf(file, {}), {"\"model.bin\"", "no folder"}));
}

TEST(Buffers, RefusesABufferWithoutBytes) {
  GltfBuilder builder = test::stone();
  builder.document["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 36}}};
  builder.document["bufferViews"][0]["buffer"] = 1;
  EXPECT_TRUE(refused(builder.load(), {"buffer 1", "neither a uri nor the binary chunk"}));
}

TEST(Buffers, RefusesABinaryChunkThatIsTooShort) {
  GltfBuilder builder = test::stone();
  builder.document["buffers"] = {{{"byteLength", 1000}}};
  EXPECT_TRUE(refused(builder.load(), {"buffer 0", "1000", "only 36 bytes"}));
}

TEST(Buffers, RefusesViewsBeyondTheBuffer) {
  const std::pair<std::uint64_t, std::uint64_t> kRanges[] = {
      {0, 37}, {37, 0}, {1, 36}, {36, 1}, {UINT64_MAX, 1}, {1, UINT64_MAX}, {8, UINT64_MAX - 7}};
  for (const auto& range : kRanges) {
    GltfBuilder builder = test::stone();
    builder.document["bufferViews"][0]["byteOffset"] = range.first;
    builder.document["bufferViews"][0]["byteLength"] = range.second;
    EXPECT_TRUE(refused(builder.load(), {"accessor 0", "bufferView 0", "buffer 0"}))
        << range.first << " " << range.second;
  }
}

TEST(Buffers, NeverReadsWhatNothingUses) {
  GltfBuilder builder = test::stone();
  builder.document["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 8}, {"uri", "gone.bin"}}};
  builder.add("bufferViews", {{"buffer", 1}, {"byteLength", 8}});
  EXPECT_TRUE(builder.load());
}

TEST(Budget, GrowsWithTheFileAndEndsThere) {
  Budget budget;
  budget.grant(1000);
  EXPECT_TRUE(budget.take(Budget::kStart + 256'000, 1, "accessor 0"));
  const Result<void> taken = budget.take(1, 4, "accessor 1");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, ErrorCode::malformed_file);
  EXPECT_EQ(taken.error().message,
            "accessor 1: 1 elements are out of proportion: the file would take more than 256 times "
            "its size in memory");
}

TEST(Budget, RefusesCountsWhoseBytesOverflow) {
  Budget budget;
  EXPECT_FALSE(budget.take(~std::uint64_t{0}, 12, "accessor 0"));
  EXPECT_TRUE(budget.take(Budget::kStart, 1, "accessor 1"));
}

TEST(Budget, HasAnEndHoweverLargeTheFile) {
  static_assert(sizeof(void*) == 4 || Budget::kMax == std::uint64_t{48} << 30);
  Budget budget;
  for (int i = 0; i < 3; ++i) budget.grant(Budget::kMax);
  EXPECT_TRUE(budget.take(Budget::kMax / 2, 2, "accessor 0"));
  const Result<void> taken = budget.take(1000, 1, "accessor 1");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().message,
            "accessor 1: 1000 elements are out of proportion: the file would take more than " +
                std::to_string(Budget::kMax >> 20) + " MiB of memory");
}

// With 32-bit addresses, two million values are too many (tests/wasm/limits.test.mjs).
TEST(Budget, AllowsAnyNumberOfValuesInATextWhereAddressesHave64Bits) {
  std::string text = "[0";
  for (int i = 0; i < 2'100'000; ++i) text += ",0";
  EXPECT_TRUE(parse_json(text + "]"));
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string decoded(std::string_view uri) {
  const Result<std::vector<std::byte>> bytes = decode_data_uri(uri);
  return bytes ? text_of(*bytes) : "refused: " + bytes.error().message;
}

TEST(DataUri, DecodesBase64OfEveryLength) {
  EXPECT_EQ(decoded("data:;base64,"), "");
  EXPECT_EQ(decoded("data:application/octet-stream;base64,YQ=="), "a");
  EXPECT_EQ(decoded("data:application/gltf-buffer;base64,YWI="), "ab");
  EXPECT_EQ(decoded("data:;base64,YWJj"), "abc");
  EXPECT_EQ(decoded("data:;base64,YWJjZA"), "abcd");
  EXPECT_EQ(decoded("data:;base64,+/+/"), "\xFB\xFF\xBF");
}

TEST(DataUri, DecodesPercentCodes) { EXPECT_EQ(decoded("data:,a%20b%2Bc"), "a b+c"); }

TEST(DataUri, RefusesWhatIsWrong) {
  EXPECT_EQ(decoded("data:;base64"), "refused: a data URI without a comma");
  EXPECT_EQ(decoded("data:;base64,YW*j"), "refused: a data URI that is not base64");
  EXPECT_EQ(decoded("data:;base64,YWJjZ"), "refused: a data URI that is not base64");
  EXPECT_EQ(decoded("data:,%4"), "refused: a data URI with an invalid percent code");
  EXPECT_EQ(decoded("data:,%zz"), "refused: a data URI with an invalid percent code");
}

class FileUri : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "sub");
    std::ofstream(outer_ / "secret.bin") << "secret";
    std::ofstream(folder_ / "sub" / "a b.bin") << "bytes";
  }
  void TearDown() override { fs::remove_all(outer_); }

  std::string resolve(std::string_view uri) const {
    const Result<fs::path> path = resolve_file_uri(uri, folder_);
    return path ? path->lexically_relative(folder_).generic_string()
                : "refused: " + path.error().message;
  }

  fs::path outer_ = folder_of_test("uri");
  fs::path folder_ = outer_ / "model";
};

TEST_F(FileUri, FindsFilesBelowTheFolder) {
  EXPECT_EQ(resolve("sub/a%20b.bin"), "sub/a b.bin");
  EXPECT_EQ(resolve("none.bin"), "none.bin");
}

TEST_F(FileUri, RefusesWhatLiesOutside) {
  const char* const kOutside[] = {"../secret.bin",
                                  "%2e%2e/secret.bin",
                                  "sub/../../secret.bin",
                                  "/etc/passwd",
                                  "%2Fetc/passwd",
                                  "..\\secret.bin",
                                  "C:secret.bin",
                                  "file:///etc/passwd",
                                  "http://host/file",
                                  "",
                                  "a%00b",
                                  "sub%2F..%2F..%2Fsecret.bin",
                                  "%zz"};
  for (const char* uri : kOutside) {
    EXPECT_NE(resolve(uri).find("is not the name of a file in the folder"), std::string::npos)
        << uri << ": " << resolve(uri);
  }
}

TEST_F(FileUri, RefusesALinkThatLeadsOut) {
  fs::create_symlink(outer_ / "secret.bin", folder_ / "link.bin");
  fs::create_directory_symlink(outer_, folder_ / "up");
  EXPECT_NE(resolve("link.bin").find("leaves the folder"), std::string::npos);
  EXPECT_NE(resolve("up/secret.bin").find("leaves the folder"), std::string::npos);
}

TEST_F(FileUri, FollowsALinkThatStaysInside) {
  fs::create_symlink("sub", folder_ / "same");
  EXPECT_EQ(resolve("same/a%20b.bin"), "same/a b.bin");
}

TEST(FileUriWithoutFolder, IsRefused) {
  const Result<fs::path> path = resolve_file_uri("a.bin", {});
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().code, ErrorCode::unsupported);
  EXPECT_NE(path.error().message.find("there is no folder to look in"), std::string::npos);
}

}  // namespace
}  // namespace pelt::asset
