/// Real characters, compared with brute force over all their posed triangles.

#include <pelt/asset.hpp>
#include <pelt/distance.hpp>

#include "brute_distance.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace pelt {
namespace {

using test::brute_distance;
using test::BruteDistance;
using test::posed_triangles;

struct Case {
  std::string model;
  double metre;  ///< one metre in units of the model
};

class DistanceOfModels : public testing::TestWithParam<Case> {};

/// A character in two poses of its first clip.
struct Actors {
  explicit Actors(const asset::Asset& asset)
      : file(asset),
        model(*build_model(asset.mesh(), {.off_weights = OffWeights::renormalise})),
        a(model),
        b(model) {}

  void move(float seconds, double shift) {
    Matrix4 placement;
    const asset::Clip* clip = file.clips.empty() ? nullptr : file.clips.data();
    std::vector<Matrix4> palette(file.joints.size());
    sample_palette(file, clip, seconds, placement, samples, palette);
    ASSERT_TRUE(a.set_palette(palette));
    placement.m[12] = static_cast<float>(shift);
    placement.m[14] = static_cast<float>(shift / 3);
    sample_palette(file, clip, seconds + 0.3f, placement, samples, palette);
    ASSERT_TRUE(b.set_palette(palette));
  }

  const asset::Asset& file;
  SkinnedModel model;
  Pose a, b;
  Scratch scratch;
  asset::SampleScratch samples;
};

TEST_P(DistanceOfModels, EqualsBruteForce) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam().model;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Actors actors(*asset);
  for (const double metres : {0.5, 1.0, 2.5}) {
    actors.move(static_cast<float>(metres), metres * GetParam().metre);
    const auto a = posed_triangles(asset->triangles, actors.a);
    const auto b = posed_triangles(asset->triangles, actors.b);
    const BruteDistance expected = brute_distance(a, b);
    Distance closest;
    distance(actors.a, actors.b, actors.scratch, closest);
    EXPECT_EQ(closest.distance, expected.distance);
    EXPECT_EQ(closest.a.triangle, expected.triangle_a);
    EXPECT_EQ(closest.b.triangle, expected.triangle_b);
    std::vector<Contact> contacts;
    std::vector<Contact> touching;
    collide(actors.a, actors.b, actors.scratch, contacts);
    clearance(actors.a, actors.b, 0, actors.scratch, touching);
    EXPECT_EQ(touching, contacts);
    EXPECT_EQ(closest.distance == 0, !contacts.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, DistanceOfModels,
                         testing::Values(Case{"knight.glb", 3}, Case{"cesium_man.glb", 1},
                                         Case{"fox_khronos.glb", 100}, Case{"spider.glb", 1}),
                         [](const auto& instance) {
                           std::string name = instance.param.model;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pelt
