/// Poses with given vertices. That every query answers as if joints had posed the vertices there is
/// part of its contract (query/query_contract_test.cpp).

#include <pelt/pelt.hpp>

#include "pose/pose.hpp"
#include "support/brute_force.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace pelt {
namespace {

using test::Random;
using test::Shape;

using Matrices = std::vector<Matrix4>;
using Points = std::vector<Vec3>;

SkinnedModel model_of(const Shape& shape) { return *build_model(shape.view()); }

Points posed(const Pose& pose) {
  Points points(pose.model().vertex_count());
  posed_vertices(pose, points);
  return points;
}

/// A pose with these vertices, whose palette has nothing to do with them.
Pose given(const SkinnedModel& model, const Points& vertices) {
  Pose pose(model);
  EXPECT_TRUE(pose.set_vertices(vertices));
  return pose;
}

Pose skinned(const SkinnedModel& model, const Matrices& palette) {
  Pose pose(model);
  EXPECT_TRUE(pose.set_palette(palette));
  return pose;
}

/// The mesh without its joints.
SkinnedMeshView without_joints(const Shape& shape) {
  SkinnedMeshView view;
  view.rest_positions = shape.rest_positions;
  view.triangles = shape.triangles;
  return view;
}

Points random_points(Random& random, std::size_t count, double size) {
  Points points(count);
  for (Vec3& p : points) p = random.point(size);
  return points;
}

TEST(SetVertices, PosedVerticesAreTheGivenOnes) {
  Random random(113);
  Shape shape = test::make_limb(10, 6, 3);
  shape.rest_positions.push_back({5, 5, 5});  // without triangles
  shape.joints.resize(shape.joints.size() + shape.influences_per_vertex, std::uint16_t{0});
  shape.weights.resize(shape.joints.size(), 0.0f);
  shape.weights[shape.weights.size() - shape.influences_per_vertex] = 1;
  const Points points = random_points(random, shape.rest_positions.size(), 3);
  EXPECT_EQ(posed(given(model_of(shape), points)), points);
}

TEST(SetVertices, EndsWithTheNextPaletteOrMorphWeights) {
  Random random(114);
  const Shape shape = test::make_morphing_limb(20, 10, 5);
  const Matrices palette = test::bend_limb(random, 5, 0.3, {});
  Pose pose = skinned(model_of(shape), palette);
  const Points skin = posed(pose);
  const Points points = random_points(random, skin.size(), 1);
  ASSERT_TRUE(pose.set_vertices(points));
  EXPECT_EQ(posed(pose), points);
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>(3)));
  EXPECT_EQ(posed(pose), skin);
  ASSERT_TRUE(pose.set_vertices(points));
  ASSERT_TRUE(pose.set_palette(palette));
  EXPECT_EQ(posed(pose), skin);
  EXPECT_EQ(check_bounds(pose), "");
}

TEST(SetVertices, ANewSetReplacesWhatQueriesOpened) {
  Random random(115);
  const Shape shape = test::make_soup(random, 80, 3, 2, test::Weights::random);
  const SkinnedModel model = model_of(shape);
  Pose a(model), b(model);
  Scratch scratch;
  CollisionSearch search(a, b);
  for (int frame = 0; frame < 6; ++frame) {
    ASSERT_TRUE(a.set_vertices(random_points(random, shape.rest_positions.size(), 1)));
    EXPECT_TRUE(search.is_stale());
    search.restart();
    EXPECT_EQ(test::contacts_of(a, b, scratch), test::brute_force(shape, a, shape, b));
  }
}

TEST(SetVertices, RefusesWhatIsNoPositionAndChangesNothing) {
  Random random(116);
  const Shape shape = test::make_limb(10, 6, 3);
  const Points points = random_points(random, shape.rest_positions.size(), 1);
  Pose pose = given(model_of(shape), points);
  const auto refusal = [&](auto change) {
    Points bad = points;
    change(bad);
    const Result<void> set = pose.set_vertices(bad);
    EXPECT_EQ(posed(pose), points);
    return set ? "accepted" : set.error().message;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal([](Points& p) { p.pop_back(); }),
            "vertices has 59 elements, expected one for each of the model's 60 vertices");
  EXPECT_EQ(refusal([](Points& p) { p.clear(); }),
            "vertices has 0 elements, expected one for each of the model's 60 vertices");
  EXPECT_EQ(refusal([&](Points& p) {
              p[7] = {1, nan, 2};
            }),
            "vertices[7] is (1, nan, 2), expected finite coordinates within 2^60");
  for (std::size_t v = 0; v < points.size(); ++v)
    for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z})
      for (const float bad : {nan, infinity, -infinity, 0x1.000002p60f}) {
        EXPECT_NE(refusal([&](Points& p) { p[v].*axis = bad; }), "accepted");
      }
}

TEST(SetVertices, HugeAndTinyCoordinatesAreExact) {
  Random random(117);
  Scratch scratch;
  const Shape shape = test::make_soup(random, 60, 3, 2, test::Weights::random);
  const SkinnedModel model = model_of(shape);
  std::size_t contacts = 0;
  for (const float scale : {0x1p60f, 0x1p-149f, 0x1p-126f, 0x1p-70f}) {
    const auto make = [&] {
      Points points(shape.rest_positions.size());
      for (Vec3& p : points) {
        const auto step = [&] { return scale * (static_cast<float>(random.index(3)) - 1); };
        p = {step(), step(), step()};
      }
      return given(model, points);
    };
    Pose a = make(), b = make();
    const std::vector<Contact> found = test::contacts_of(a, b, scratch);
    EXPECT_EQ(found, test::brute_force(shape, a, shape, b));
    contacts += found.size();
  }
  EXPECT_GT(contacts, 100u);
}

/// A square of two triangles that do not share their two common vertices.
Shape split_square() {
  Shape shape;
  shape.influences_per_vertex = 1;
  shape.rest_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  shape.triangles = {{0, 1, 2}, {3, 4, 5}};
  shape.joints.resize(6, 0);
  shape.weights.resize(6, 1);
  return shape;
}

TEST(SetVertices, MergedVerticesMustAgree) {
  const Shape shape = split_square();
  Points points = shape.rest_positions;
  points[1].z = points[3].z = 2;
  Pose merged(model_of(shape));
  ASSERT_TRUE(merged.set_vertices(points));
  EXPECT_EQ(posed(merged), points);
  points[5].y = 3;
  EXPECT_EQ(merged.set_vertices(points).error().message,
            "vertices[5] differs from vertices[2], but the model has merged both because they are "
            "equal in the rest pose: build it with ModelOptions::weld = false");
}

TEST(SetVertices, VerticesThatAreNotMergedMoveApart) {
  const Shape shape = split_square();
  Points points = shape.rest_positions;
  points[3].z = points[4].z = points[5].z = 1;
  const SkinnedModel built = *build_model(shape.view(), {.weld = false});
  for (const SkinnedModel& model : {built, *load_model(save_model(built))}) {
    Pose pose = given(model, points), other(model);
    EXPECT_EQ(posed(pose), points);
    Scratch scratch;
    EXPECT_EQ(test::contacts_of(pose, other, scratch),
              test::brute_force(shape, pose, shape, other));
    const Result<VertexGroups> groups = group_triangles(model, std::vector<std::uint32_t>{0, 1});
    Box box;
    exact_group_bounds(pose, *groups, 1, box);
    EXPECT_EQ(box.low, Vec3({0, 0, 1}));
  }
}

TEST(SetVertices, ReservingKeepsThem) {
  Random random(119);
  const Shape shape = test::make_limb(20, 10, 5);
  const Points points = random_points(random, shape.rest_positions.size(), 1);
  Pose pose = given(model_of(shape), points);
  pose.reserve();
  EXPECT_EQ(posed(pose), points);
  EXPECT_EQ(check_bounds(pose), "");
}

TEST(SetVertices, SkinsNothing) {
  Random random(120);
  const Shape shape = test::make_morphing_limb(20, 10, 5);
  Pose pose(model_of(shape));
  ASSERT_TRUE(pose.set_morph_weights(std::vector<float>{1, 1, 1}));
  ASSERT_TRUE(pose.set_vertices(random_points(random, shape.rest_positions.size(), 1)));
  Bounds box;
  const QueryStats work = exact_bounds(pose, box);
  EXPECT_EQ(work.posed_vertices + work.displacements, 0u);
  EXPECT_GT(work.refits, 1u);
}

TEST(SetVertices, TrackersFollow) {
  Random random(121);
  const Shape shape = test::make_limb(40, 12, 5);
  const SkinnedModel model = model_of(shape);
  const SelfFilter filter = *build_self_filter(model);
  SelfTracker tracker(filter);
  Scratch scratch;
  Pose pose(model);
  std::size_t contacts = 0;
  for (int frame = 0; frame < 40; ++frame) {
    Random same(5);
    const Pose bent = skinned(model, test::bend_limb(same, 5, 0.05 * frame, {}));
    Points points = posed(bent);
    if (frame % 10 == 9) points = random_points(random, points.size(), 1);
    if (frame % 4 == 3)
      ASSERT_TRUE(pose.set_palette(bent.detail().palette.joints()));
    else
      ASSERT_TRUE(pose.set_vertices(points));
    std::vector<Contact> expected, found;
    self_collide(pose, filter, scratch, expected);
    self_collide(pose, tracker, scratch, found);
    EXPECT_EQ(found, expected) << "frame " << frame;
    contacts += expected.size();
  }
  EXPECT_GT(contacts, 100u);
}

TEST(MeshWithoutJoints, FollowsOneMatrixUntilVerticesAreGiven) {
  Random random(122);
  const Shape shape = test::make_limb(10, 6, 3);
  const Result<SkinnedModel> model = build_model(without_joints(shape));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->joint_count(), 1u);
  Pose pose(*model);
  EXPECT_EQ(posed(pose), shape.rest_positions);
  Matrix4 moved;
  moved.m[12] = 3;
  ASSERT_TRUE(pose.set_palette(std::vector{moved}));
  EXPECT_EQ(posed(pose)[5].x, shape.rest_positions[5].x + 3);
  const Points points = random_points(random, shape.rest_positions.size(), 1);
  ASSERT_TRUE(pose.set_vertices(points));
  EXPECT_EQ(posed(pose), points);
  Scratch scratch;
  Pose other(*load_model(save_model(*model)));
  EXPECT_EQ(test::contacts_of(pose, other, scratch), test::brute_force(shape, pose, shape, other));
}

TEST(MeshWithoutJoints, HasNoWeights) {
  const Shape shape = test::make_limb(10, 6, 3);
  SkinnedMeshView view = without_joints(shape);
  view.weights = shape.weights;
  EXPECT_EQ(build_model(view).error().message,
            "joint_count is 0, but joints has 0 and weights has 240 elements");
}

}  // namespace
}  // namespace pelt
