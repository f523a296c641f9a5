#include "asset/uri.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace pelt::asset {
namespace {

namespace fs = std::filesystem;

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

  fs::path outer_ =
      fs::path(::testing::TempDir()) /
      (std::string("pelt-uri-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
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
