/// Allocation failures while a file is read.

#include <pelt/asset.hpp>

#include "asset/uri.hpp"
#include "scenes/scene_file.hpp"
#include "support/failing_allocation.hpp"
#include "support/gltf_builder.hpp"
#include "support/gltf_corpus.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace pelt::test {
namespace {

std::vector<std::byte> file_of(const GltfSeed& seed) {
  if (!seed.binary.empty()) return make_glb(seed.json, seed.binary);
  const auto* first = reinterpret_cast<const std::byte*>(seed.json.data());
  return {first, first + seed.json.size()};
}

/// Whether all allocations fail after the first failure.
class AssetMemory : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(ForEver, AssetMemory, testing::Bool());

TEST_P(AssetMemory, EndsAnywhereAndNothingLeaks) {
  std::size_t failures = 0;
  for (const GltfSeed& seed : gltf_corpus()) {
    SCOPED_TRACE(seed.name);
    const std::vector<std::byte> file = file_of(seed);
    const auto load = [&] {
      const Result<asset::Asset> asset = asset::load_gltf(file, {});
      EXPECT_TRUE(asset) << asset.error().message;
    };
    load();
    const std::ptrdiff_t before = live_allocations();
    failures += fail_each_allocation(
        load, [&] { EXPECT_EQ(live_allocations(), before); }, GetParam());
    EXPECT_EQ(live_allocations(), before);
  }
  EXPECT_GT(failures, 500u);
}

/// Loading a file by its path returns an error, not an exception, and the same file loads
/// afterwards.
TEST(AssetFileMemory, IsToldWithTheFilesName) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "pelt_asset_memory.glb";
  const std::vector<std::byte> file = file_of(gltf_corpus()[0]);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  std::size_t named = 0;
  const std::size_t failures = fail_each_allocation(
      [&] {
        const Result<asset::Asset> asset = asset::load_gltf(path);
        if (asset) return;
        EXPECT_EQ(asset.error().code, ErrorCode::unreadable_file);
        EXPECT_NE(asset.error().message.find(path.string()), std::string::npos);
        EXPECT_NE(asset.error().message.find("more memory"), std::string::npos);
        ++named;
      },
      [] { ADD_FAILURE() << "an exception left load_gltf"; });
  std::filesystem::remove(path);
  EXPECT_GT(named, 50u);
  EXPECT_GE(failures, named);
}

// Allocation failures while a scene file and the files of its models are read.

constexpr const char* kScene = R"({
  "$schema": "scene.schema.json",
  "models": {"b": {"creature": {"triangles": 8270, "joints": 27, "seed": 5}}, "a": "x/a.glb"},
  "frames": {"count": 7, "fps": 12.5},
  "ignore": [["a", "b"], ["a/cape", "b/spine"]],
  "instances": [
    {"model": "b", "clip": "", "start": 0.25, "speed": -2, "translation": [1, 2, 3],
     "rotation": [0, 0.6, 0, 0.8], "scale": 0.5, "velocity": [0, 0, -1],
     "morph_weights": {"smile": 0.5}},
    {"model": "a", "clip": null}]})";

/// Whether all allocations fail after the first failure.
class SceneMemory : public testing::TestWithParam<bool> {
 protected:
  void fail_and_leak_nothing(const std::function<void()>& operation) {
    operation();
    const std::ptrdiff_t before = live_allocations();
    const std::size_t failures = fail_each_allocation(
        operation, [&] { EXPECT_EQ(live_allocations(), before); }, GetParam());
    EXPECT_EQ(live_allocations(), before);
    EXPECT_GT(failures, 20u);
  }
};

INSTANTIATE_TEST_SUITE_P(ForEver, SceneMemory, testing::Bool());

TEST_P(SceneMemory, EndsWhileASceneIsParsed) {
  fail_and_leak_nothing([] {
    const Result<scenes::SceneFile> scene = scenes::parse_scene_file(kScene);
    EXPECT_TRUE(scene) << scene.error().message;
  });
}

TEST_P(SceneMemory, EndsWhileReferencedFilesAreListed) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      (GetParam() ? "pelt_scene_memory_for_ever.gltf" : "pelt_scene_memory.gltf");
  std::ofstream(path) << R"({"buffers": [{"uri": "a.bin", "extras": [[1, 2], {"b": [3]}]}],
                             "images": [{"uri": "a.png"}, {"uri": "b.png"}]})";
  fail_and_leak_nothing([&] { EXPECT_EQ(asset::referenced_files(path).size(), 3u); });
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace pelt::test
