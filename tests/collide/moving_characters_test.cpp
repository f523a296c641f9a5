/// Real characters between two frames of their clips, compared with a test of all pairs of their
/// triangles.

#include <pelt/self.hpp>

#include "self/self_brute_force.hpp"
#include "self/self_moving_brute_force.hpp"
#include "support/animated_character.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::test {
namespace {

struct Case {
  const char* model;
  std::size_t least_later;  ///< contacts that are not at the start, at least
};

using MovingCharacters = OfSharedModels<Case>;

TEST_P(MovingCharacters, IntersectThemselvesAsByATestOfAllPairs) {
  const SkinnedMeshView mesh = character->asset.mesh();
  Pose& from = character->pose;
  Pose to(from.model());
  const SelfFilter filter = *build_self_filter(from.model());
  const auto corners = surface_corners(mesh.triangles, surface_vertices(mesh));
  Scratch scratch;
  std::size_t contacts = 0, later = 0;
  for (const asset::Clip& clip : character->asset.clips) {
    character->move(from, &clip, clip.duration / 2);
    character->move(to, &clip, clip.duration / 2 + 1.0f / 30);
    const MovingTriangles triangles = moving_triangles(mesh.triangles, from, to);
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
                         kStemOfModel);

}  // namespace
}  // namespace pelt::test
