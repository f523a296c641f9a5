/// Volumes of bodies with themselves, against intersections with a copy of the body: an independent
/// path, which decides each triangle against its neighbours, too.

#include <pelt/inside.hpp>
#include <pelt/self.hpp>
#include <pelt/self_filter.hpp>

#include "support/animated_character.hpp"
#include "support/closed_body.hpp"
#include "volume/self_volume_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <thread>
#include <vector>

namespace pelt::test {
namespace {

TEST(SelfIntersectionVolume, IsThatOfOverlappingParts) {
  const Shape cube = make_cube(1, {0, 0, 0}), part = make_cube(1, {1, 0, 0});
  const auto overlap = [&](const Shape& shape) {
    Body body(shape);
    const Volume found = self_intersection_of(body);
    EXPECT_LT(found.error, 1e-12);
    return found.value;
  };
  EXPECT_NEAR(overlap(cube), 0, 1e-12);
  EXPECT_NEAR(overlap(make_sphere(1, 3)), 0, 1e-12);
  EXPECT_NEAR(overlap(together(cube, part)), 4, 1e-12);
  const Shape second = make_cube(0.875f, {0, 0, 0}), third = make_cube(0.75f, {0, 0, 0});
  const double least = 1.5 * 1.5 * 1.5, middle = 1.75 * 1.75 * 1.75;
  EXPECT_NEAR(overlap(together(cube, second)), middle, 1e-12);
  EXPECT_NEAR(overlap(together(cube, together(second, third))), middle + 2 * least, 1e-12)
      << "three pairs";
}

/// Two limbs in one mesh that cross each other.
Shape crossing_limbs() {
  Shape limbs = make_limb(24, 13, 4);
  const Shape across = make_limb(24, 11, 4);
  const auto first = static_cast<std::uint32_t>(limbs.rest_positions.size());
  for (const Vec3& p : across.rest_positions)
    limbs.rest_positions.push_back({p.y - 0.5f, 0.5f - p.x, p.z + 0.03f});
  for (const Triangle& t : across.triangles)
    limbs.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  limbs.joints.insert(limbs.joints.end(), across.joints.begin(), across.joints.end());
  limbs.weights.insert(limbs.weights.end(), across.weights.begin(), across.weights.end());
  return limbs;
}

TEST(SelfIntersectionVolume, EqualsThatOfACopy) {
  Random random(44);
  int hits = 0;
  for (const Shape& shape : {make_limb(24, 13, 4), crossing_limbs()}) {
    Body body(shape);
    for (int i = 0; i < 15; ++i) {
      body.set(bend_limb(random, 4, i % 3 == 0 ? 1.5 : 0.7, {0, 0, 0}));
      const Volume found = self_intersection_of(body);
      expect_equal_within_errors(found, volume_with_a_copy(body.pose));
      EXPECT_LT(found.error, 1e-14);
      hits += found.value > 1e-6;
    }
  }
  EXPECT_GT(hits, 15);
}

TEST(SelfIntersectionVolume, EqualsThatOfACopyWhereLayersCoincide) {
  const Shape sphere = make_sphere(1, 3);
  Shape layers = together(sphere, sphere);
  const std::vector<Vec3> given = layers.rest_positions;
  for (std::size_t v = sphere.rest_positions.size(); v < given.size(); ++v)
    layers.rest_positions[v].x += 4;  // otherwise, the layers would share their vertices
  Body body(layers);
  ASSERT_TRUE(body.pose.set_vertices(given));
  const Volume found = self_intersection_of(body);
  expect_equal_within_errors(found, volume_with_a_copy(body.pose));
  Body one(sphere);
  EXPECT_NEAR(found.value, volume_of(one).value, found.error + volume_of(one).error);
}

TEST(SelfIntersectionVolume, CanBeAskedForByThreadsThatShareASurface) {
  Random random(47);
  const auto palette = bend_limb(random, 4, 0.7, {0, 0, 0});
  Body body(crossing_limbs());
  std::array<Volume, 4> found;
  std::vector<std::thread> threads;
  for (Volume& volume : found)
    threads.emplace_back([&] {
      Pose pose(body.pose.model());
      Scratch scratch;
      ASSERT_TRUE(pose.set_palette(palette));
      self_intersection_volume(pose, scratch, volume);
    });
  for (std::thread& thread : threads) thread.join();
  body.set(palette);
  const Volume expected = self_intersection_of(body);
  EXPECT_GT(expected.value, 0);
  for (const Volume& volume : found) {
    EXPECT_EQ(volume.value, expected.value);
    EXPECT_EQ(volume.error, expected.error);
  }
}

TEST(SelfIntersectionVolume, CountsItsWork) {
  Body body(crossing_limbs());
  Scratch scratch;
  std::vector<Contact> contacts;
  Volume found;
  const QueryStats work = self_intersection_volume(body.pose, scratch, found);
  Body again(crossing_limbs());
  const QueryStats collide =
      self_collide(again.pose, *build_self_filter(again.pose.model()), scratch, contacts);
  EXPECT_GT(found.value, 0);
  EXPECT_EQ(work.posed_vertices, collide.posed_vertices);
  EXPECT_GE(work.triangle_pairs, collide.triangle_pairs + contacts.size());
  EXPECT_GT(work.node_pairs, collide.node_pairs) << "two rays";
}

// Volumes of real characters with themselves, against intersections with a copy.

struct Case {
  const char* model;
  std::size_t most_clips;
  int frames, least_overlaps;
};

using SelfVolumeOfCharacters = OfSharedModels<Case>;

TEST_P(SelfVolumeOfCharacters, EqualsThatOfACopy) {
  const std::vector<asset::Clip>& all = character->asset.clips;
  Pose& pose = character->pose;
  ASSERT_TRUE(pose.model().surface().is_closed());
  Scratch scratch;
  int overlaps = 0;
  const std::size_t clips = std::min(all.size(), GetParam().most_clips);
  for (const asset::Clip& clip : std::span(all).first(clips))
    for (int frame = 0; frame < GetParam().frames; ++frame) {
      SCOPED_TRACE(testing::Message() << "clip " << clip.name << ", frame " << frame);
      const float share = static_cast<float>(frame) / static_cast<float>(GetParam().frames);
      character->move(&clip, clip.duration * share);
      Volume found;
      self_intersection_volume(pose, scratch, found);
      const Volume expected = volume_with_a_copy(pose);
      expect_equal_within_errors(found, expected);
      EXPECT_LT(found.error, expected.error);
      overlaps += std::abs(found.value) > found.error;
    }
  EXPECT_GE(overlaps, GetParam().least_overlaps);
}

INSTANTIATE_TEST_SUITE_P(Shared, SelfVolumeOfCharacters,
                         testing::Values(Case{"cesium_man.glb", 1, 8, 8},
                                         Case{"fox_khronos.glb", 3, 8, 18},
                                         Case{"fox_m2m.glb", 14, 3, 42}, Case{"human.glb", 4, 2, 8},
                                         Case{"human_8inf.glb", 2, 2, 4},
                                         Case{"morph_stress.glb", 3, 2, 0}),
                         kStemOfModel);

}  // namespace
}  // namespace pelt::test
