/// Real characters between two frames of their clips, compared with a test of all pairs of their
/// triangles.

#include <pelt/asset.hpp>
#include <pelt/self.hpp>

#include "self/self_brute_force.hpp"
#include "self/self_moving_brute_force.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace pelt::test {
namespace {

struct Case {
  const char* model;
  std::size_t least_later;  ///< contacts that are not at the start, at least
};

class MovingCharacters : public testing::TestWithParam<Case> {};

TEST_P(MovingCharacters, IntersectThemselvesAsByATestOfAllPairs) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam().model;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  const SkinnedMeshView mesh = asset->mesh();
  Pose from(*build_model(mesh, {.off_weights = OffWeights::renormalise})), to(from.model());
  const SelfFilter filter = *build_self_filter(from.model());
  const auto corners = surface_corners(mesh.triangles, surface_vertices(mesh));
  asset::SampleScratch samples;
  std::vector<Matrix4> palette(asset->joints.size());
  const auto move = [&](Pose& pose, const asset::Clip& clip, float seconds) {
    sample_palette(*asset, &clip, seconds, {}, samples, palette);
    ASSERT_TRUE(pose.set_palette(palette));
  };
  Scratch scratch;
  std::size_t contacts = 0, later = 0;
  for (const asset::Clip& clip : asset->clips) {
    move(from, clip, clip.duration / 2);
    move(to, clip, clip.duration / 2 + 1.0f / 30);
    std::vector<Vec3> first(mesh.rest_positions.size()), last(first.size());
    posed_vertices(from, first);
    posed_vertices(to, last);
    std::vector<detail::MovingTriangle> triangles;
    for (const Triangle& t : mesh.triangles)
      triangles.push_back(
          {{first[t[0]], first[t[1]], first[t[2]]}, {last[t[0]], last[t[1]], last[t[2]]}});
    std::vector<MovingContact> found;
    self_collide({from, to}, filter, scratch, found);
    ASSERT_EQ(found, brute_force_self_moving(triangles, corners, true)) << clip.name;
    contacts += found.size();
    for (const MovingContact& c : found) later += !c.at_start;
    if (contacts > 20'000) break;
  }
  std::printf("%zu contacts, %zu not at the start\n", contacts, later);
  EXPECT_GE(later, GetParam().least_later);
}

INSTANTIATE_TEST_SUITE_P(Shared, MovingCharacters,
                         testing::Values(Case{"cesium_man.glb", 1}, Case{"fox_khronos.glb", 1},
                                         Case{"knight.glb", 100}, Case{"robot_expressive.glb", 10}),
                         [](const auto& param_info) {
                           const std::string name = param_info.param.model;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pelt::test
