/// If memory is insufficient, the message names the file, and it is not an internal error.

#include "support/sanitizers.hpp"
#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <filesystem>
#include <fstream>

namespace pelt::test {
namespace {

/// A sparse file, larger than the memory limit of `run_limited`.
void write_huge(const TestFolder& folder, const std::string& name) {
  std::ofstream(folder / name);
  std::filesystem::resize_file(folder / name, std::uintmax_t{1} << 36);
}

Ended run_limited(const TestFolder& folder, const std::string& arguments) {
  return run_program(folder.path(),
                     {"sh", "-c", "ulimit -v 4000000; '" PELT_COMMAND "' " + arguments});
}

class MemoryLimit : public ::testing::Test {
 protected:
  void SetUp() override {
    if (kHasSanitizer) GTEST_SKIP() << "sanitizers reserve more address space than the limit";
  }

  void expect_named(const std::string& arguments, const std::string& name) {
    const Ended run = run_limited(folder_, arguments);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_NE(run.err.find(name), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("needs more memory than there is"), std::string::npos) << run.err;
  }

  TestFolder folder_;
};

TEST_F(MemoryLimit, NamesAHugeModel) {
  write_huge(folder_, "huge.glb");
  expect_named("info huge.glb", "huge.glb");
  expect_named("check huge.glb", "huge.glb");
}

TEST_F(MemoryLimit, NamesAHugeScene) {
  write_huge(folder_, "scene.json");
  expect_named("check scene.json", "scene.json");
}

TEST_F(MemoryLimit, NamesAHugeBuffer) {
  write_huge(folder_, "body.bin");
  std::ofstream(folder_ / "body.gltf")
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      << R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      << R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      << R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
      << R"("buffers":[{"byteLength":36,"uri":"body.bin"}]})";
  expect_named("info body.gltf", "body.bin");
}

}  // namespace
}  // namespace pelt::test
