/// Closed characters have no leaks; all kinds of files are compared with the oracle.

#include "ray_cases.hpp"
#include "ray_oracle.hpp"
#include "scenes/scene.hpp"
#include "support/animated_character.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

AnimatedCharacter make_walker(float seconds) {
  AnimatedCharacter walker(scenes::generate_character(scenes::kDwarf)->asset);
  walker.move(walker.first_clip(), seconds);
  return walker;
}

RayOracle oracle_of(const AnimatedCharacter& character) {
  return {character.asset.triangles, character.pose};
}

bool is_on_edge(const RayHit& hit) {
  return hit.barycentrics[0] == 0 || hit.barycentrics[1] == 0 || hit.barycentrics[2] == 0;
}

/// Negative if the ray enters.
float along(const Vec3& direction, const Vec3& normal) {
  return direction.x * normal.x + direction.y * normal.y + direction.z * normal.z;
}

TEST(Watertight, ARayFromOutsideEntersAsOftenAsItLeaves) {
  Random random(100);
  Scratch scratch;
  int crossed = 0;
  for (const float seconds : {0.0f, 0.3f, 0.7f}) {
    AnimatedCharacter walker = make_walker(seconds);
    const RayOracle oracle = oracle_of(walker);
    const RayCases cases(walker.asset.triangles, oracle.positions());
    for (int i = 0; i < 800; ++i) {
      Vec3 far = random.point(1);
      far = {far.x, far.y + 1, far.z + (far.z < 0 ? -10.0f : 10.0f)};
      Ray ray = segment(far, cases.target(random));
      ray.t_max = 3;
      std::vector<RayHit> front, back;
      cast_all(walker.pose, ray, scratch, front, Facing::front);
      cast_all(walker.pose, ray, scratch, back, Facing::back);
      if (std::any_of(front.begin(), front.end(), is_on_edge) ||
          std::any_of(back.begin(), back.end(), is_on_edge))
        continue;
      ASSERT_EQ(front.size(), back.size()) << "ray " << i;
      ++crossed;
    }
  }
  EXPECT_GT(crossed, 800);
}

/// From points inside, through vertices and edges as exactly as floats allow, and anywhere.
TEST(Watertight, ARayFromInsideAlwaysHits) {
  Random random(101);
  Scratch scratch;
  int places = 0, on_edges = 0;
  for (const float seconds : {0.0f, 0.4f}) {
    AnimatedCharacter walker = make_walker(seconds);
    const RayOracle oracle = oracle_of(walker);
    const RayCases cases(walker.asset.triangles, oracle.positions());
    for (int i = 0; i < 150; ++i) {
      const Ray ray = {{random.uniformf(-0.3, 0.3), random.uniformf(0.2, 1.7), 10}, {0, 0, -1}};
      std::vector<RayHit> all;
      cast_all(walker.pose, ray, scratch, all);
      if (all.size() < 2 || is_on_edge(all[0]) || is_on_edge(all[1])) continue;
      const bool goes_in_and_out =
          along(ray.direction, all[0].normal) < 0 && along(ray.direction, all[1].normal) > 0;
      if (!goes_in_and_out || all[1].t - all[0].t < 1e-3f) continue;
      ++places;
      const Vec3 inside = {ray.origin.x, ray.origin.y, 10 - (all[0].t + all[1].t) / 2};
      for (int j = 0; j < 100; ++j) {
        const Vec3 direction =
            j % 2 == 0 ? random.point(1) : segment(inside, cases.target(random)).direction;
        const RayHit hit = test::first_hit(walker.pose, {inside, direction});
        ASSERT_TRUE(hit) << "ray " << j;
        on_edges += is_on_edge(hit);
      }
      for (const Vec3& axis : {Vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}})
        ASSERT_TRUE(test::first_hit(walker.pose, {inside, axis}));
    }
  }
  std::printf("%d places inside, %d rays through edges\n", places, on_edges);
  EXPECT_GT(places, 50);
}

using RealModel = OfSharedModels<>;

TEST_P(RealModel, EqualsBruteForce) {
  Random random(102);
  Scratch scratch;
  std::size_t hits = 0, several = 0;
  for (const float seconds : {0.0f, 0.5f}) {
    character->move(character->first_clip(), seconds);
    const RayOracle oracle = oracle_of(*character);
    const RayCases cases(character->asset.triangles, oracle.positions());
    for (int i = 0; i < 200; ++i) {
      const std::size_t count =
          expect_as_oracle(character->pose, oracle, cases.next(random), scratch);
      hits += count > 0;
      several += count > 2;
    }
  }
  EXPECT_GT(hits, 150u);
  EXPECT_GT(several, 30u);
}

INSTANTIATE_TEST_SUITE_P(Files, RealModel,
                         ::testing::Values("fox_khronos.glb", "human.glb", "knight.glb",
                                           "mech_george.glb", "spider.glb"));

}  // namespace
}  // namespace pelt::test
