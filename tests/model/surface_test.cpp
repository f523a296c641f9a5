#include "model/surface.hpp"

#include "model/model.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace pelt::test {
namespace {

SkinnedModel model_of(const Shape& shape) { return *build_model(shape.view()); }

TEST(Surface, OfALimbIsClosed) { EXPECT_TRUE(model_of(make_limb(12, 9, 3)).surface().is_closed()); }

TEST(Surface, IsMadeOnceForAllCopiesOfAModel) {
  const SkinnedModel model = model_of(make_limb(12, 9, 3)), copy = model;
  std::vector<const detail::Surface*> seen(8);
  std::vector<std::thread> threads;
  for (const detail::Surface*& surface : seen)
    threads.emplace_back([&] { surface = &copy.surface().detail(); });
  for (std::thread& thread : threads) thread.join();
  for (const detail::Surface* surface : seen) EXPECT_EQ(surface, &model.surface().detail());
}

TEST(Surface, OutlivesTheModelThatMadeIt) {
  const Surface surface = model_of(make_limb(12, 9, 3)).surface();
  EXPECT_TRUE(surface.is_closed());
}

TEST(Surface, WithAHoleIsNotClosed) {
  Shape limb = make_limb(12, 9, 3);
  limb.triangles.pop_back();
  EXPECT_FALSE(model_of(limb).surface().is_closed());
}

TEST(Surface, WithATriangleTurnedRoundIsNotClosed) {
  Shape limb = make_limb(12, 9, 3);
  std::swap(limb.triangles[5][0], limb.triangles[5][1]);
  EXPECT_FALSE(model_of(limb).surface().is_closed());
}

/// A limb in which no two triangles share a vertex index.
Shape split_limb() {
  const Shape limb = make_limb(12, 9, 3);
  Shape split = limb;
  split.rest_positions.clear();
  split.joints.clear();
  split.weights.clear();
  const std::uint32_t k = limb.influences_per_vertex;
  for (Triangle& triangle : split.triangles)
    for (std::uint32_t& vertex : triangle) {
      split.rest_positions.push_back(limb.rest_positions[vertex]);
      for (std::uint32_t i = 0; i < k; ++i) {
        split.joints.push_back(limb.joints[vertex * k + i]);
        split.weights.push_back(limb.weights[vertex * k + i]);
      }
      vertex = static_cast<std::uint32_t>(split.rest_positions.size() - 1);
    }
  return split;
}

TEST(Surface, IsClosedAcrossSeams) { EXPECT_TRUE(model_of(split_limb()).surface().is_closed()); }

TEST(Surface, IsOpenAlongSeamsThatTheModelHasNotMerged) {
  const Shape split = split_limb();
  EXPECT_FALSE(build_model(split.view(), {.weld = false})->surface().is_closed());
  SkinnedMeshView view = split.view();
  std::vector<float> caps(split.rest_positions.size(), 0);
  view.offset_caps = caps;
  EXPECT_TRUE(build_model(view)->surface().is_closed());
  caps[5] = 0.25f;
  EXPECT_FALSE(build_model(view)->surface().is_closed());
}

TEST(Surface, OfATriangleWithARepeatedVertexIsNotClosed) {
  Shape shape = make_limb(12, 9, 3);
  for (const Triangle& triangle : {Triangle{3, 3, 7}, {3, 7, 3}, {7, 3, 3}, {5, 5, 5}}) {
    shape.triangles = {triangle};
    EXPECT_FALSE(model_of(shape).surface().is_closed());
  }
}

/// The poles of a sphere made of quads have such triangles.
TEST(Surface, StaysClosedWithTrianglesThatRepeatAVertex) {
  Shape limb = make_limb(12, 9, 3);
  const auto [a, b, c] = limb.triangles[5];
  limb.triangles.push_back({a, b, b});
  limb.triangles.push_back({c, c, c});
  EXPECT_TRUE(model_of(limb).surface().is_closed());
}

TEST(Surface, NamesTheJointThatATriangleFollowsMost) {
  Shape shape;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}};
  shape.influences_per_vertex = 2;
  shape.joint_count = 3;
  shape.joints = {0, 1, 1, 2, 2, 1};
  shape.weights = {0.75f, 0.25f, 0.5f, 0.5f, 0.75f, 0.25f};  // 0.75, 1, 1.25
  EXPECT_EQ(model_of(shape).surface().detail().joints[0], 2);
  shape.weights = {1, 0, 0.75f, 0.25f, 0.75f, 0.25f};  // 1, 1, 1
  EXPECT_EQ(model_of(shape).surface().detail().joints[0], 0);
}

}  // namespace
}  // namespace pelt::test
