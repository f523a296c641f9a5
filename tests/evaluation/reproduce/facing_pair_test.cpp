/// The pairs for comparing methods have the stated distances.

#include "evaluation/reproduce/comparison.hpp"
#include "evaluation/reproduce/scene_figures.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::reproduce {
namespace {

scenes::Character small_creature() {
  auto creature = scenes::generate_character({1000, 24, 1});
  EXPECT_TRUE(creature) << creature.error().message;
  return std::move(*creature);
}

/// From middle to middle.
double distance_at(const scenes::Scene& scene, std::uint32_t frame) {
  const auto z = [&](const scenes::Instance& one) {
    return one.translation[2] + one.velocity[2] * scenes::frame_time(scene, frame);
  };
  return z(scene.instances[1]) - z(scene.instances[0]);
}

TEST(FacingPair, HasEvenPhasesOfTheWalk) {
  const scenes::Character creature = small_creature();
  const scenes::Scene scene = facing_pair(creature, 0.7, 4);
  ASSERT_EQ(scene.frame_count, 4u);
  const double duration = creature.asset.find_clip("walk")->duration;
  EXPECT_NEAR(scenes::frame_time(scene, 1), duration / 4, 1e-6);
  EXPECT_DOUBLE_EQ(distance_at(scene, 0), 0.7);
  EXPECT_DOUBLE_EQ(distance_at(scene, 3), 0.7);
}

TEST(ClosingPair, ComesFromOneDistanceToTheOther) {
  const scenes::Scene scene = closing_pair(small_creature(), 0.9, 0.3, 16);
  EXPECT_NEAR(distance_at(scene, 0), 0.9, 1e-9);
  EXPECT_NEAR(distance_at(scene, 5), 0.7, 1e-9);
  EXPECT_NEAR(distance_at(scene, 15), 0.3, 1e-9);
}

TEST(HeapBytes, CountWhatIsHeld) {
  const auto before = heap_bytes();
  if (!before) GTEST_SKIP() << "this C library does not count the bytes of the heap";
  const std::vector<char> held(1 << 20, 'x');
  const auto after = heap_bytes();
  if (*after == *before) GTEST_SKIP() << "another allocator is in use";
  EXPECT_GE(*after - *before, held.size());
}

}  // namespace
}  // namespace pelt::reproduce
