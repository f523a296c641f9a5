#include <pelt/bounds.hpp>

#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace pelt {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

/// Small integers times a power of two, so that dot products are exact.
Vec3 grid_direction(Random& random) {
  const auto component = [&] { return (static_cast<float>(random.index(7)) - 3) * 0x1p-40f; };
  const Vec3 d = {component(), component(), component()};
  return d.x == 0 && d.y == 0 && d.z == 0 ? Vec3{1, 0, 0} : d;
}

/// Uses long double, which is exact for directions of grid_direction and usual positions.
long double along(const Vec3& d, const Vec3& p) {
  return static_cast<long double>(d.x) * p.x + static_cast<long double>(d.y) * p.y +
         static_cast<long double>(d.z) * p.z;
}

struct Farthest {
  std::uint32_t triangle = 0, corner = 0;
  std::uint32_t equals = 0;  ///< vertices at the same distance
};

Farthest brute_farthest(const Shape& shape, const Pose& pose, const Vec3& direction) {
  std::vector<Vec3> positions(shape.rest_positions.size());
  posed_vertices(pose, positions);
  Farthest best;
  for (std::uint32_t t = 0; t < shape.triangles.size(); ++t)
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const long double here = along(direction, positions[shape.triangles[t][corner]]);
      const long double there =
          along(direction, positions[shape.triangles[best.triangle][best.corner]]);
      if (here > there) best = {t, corner, 0};
      if (here >= there) ++best.equals;
    }
  return best;
}

struct Counts {
  int queries = 0, ties = 0;
};

void expect_brute_force(Random& random, const Shape& shape, Pose& pose, Counts& counts) {
  for (int i = 0; i < 8; ++i) {
    const Vec3 direction = grid_direction(random);
    const Farthest expected = brute_farthest(shape, pose, direction);
    test::on_each_instruction_set([&](InstructionSet) {
      FarthestVertex found;
      farthest_vertex(pose, direction, found);
      ASSERT_TRUE(found);
      ASSERT_EQ(found.triangle, expected.triangle);
      ASSERT_EQ(found.corner, expected.corner);
    });
    ++counts.queries;
    counts.ties += expected.equals > 1;
  }
}

TEST(FarthestVertex, EqualsBruteForce) {
  Random random(940);
  Counts counts;
  for (int round = 0; round < 20; ++round) {
    const Shape limb = test::make_limb(24, 10, 5);
    Pose pose(*build_model(limb.view()));
    ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 5, 0.4, random.point(1))));
    expect_brute_force(random, limb, pose, counts);
  }
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed})
    for (const Weights weights : {Weights::one_joint, Weights::adversarial}) {
      const Shape soup = test::make_soup(random, 150, 6, 3, weights);
      Pose pose(*build_model(soup.view()));
      ASSERT_TRUE(pose.set_palette(test::make_palette(random, 6, motion, 1)));
      expect_brute_force(random, soup, pose, counts);
    }
  EXPECT_EQ(counts.queries, 8 * 26);
  EXPECT_GT(counts.ties, counts.queries / 2);  // a limb's vertices belong to several triangles
}

TEST(FarthestVertex, OpensFewNodes) {
  Random random(941);
  const Shape limb = test::make_limb(200, 40, 5);
  Pose pose(*build_model(limb.view()));
  std::uint64_t posed = 0;
  for (int round = 0; round < 10; ++round) {
    ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 5, 0.4, random.point(1))));
    FarthestVertex found;
    posed += farthest_vertex(pose, random.point(1), found).posed_vertices;
  }
  EXPECT_GT(posed, 0u);
  EXPECT_LT(posed, 10 * limb.rest_positions.size() / 4);
}

TEST(FarthestVertex, AcceptsDirectionsOfAnyLength) {
  const Shape limb = test::make_limb(24, 10, 5);
  Pose pose(*build_model(limb.view()));
  FarthestVertex unit, tiny, huge;
  farthest_vertex(pose, {1, -2, 3}, unit);
  farthest_vertex(pose, {0x1p-149f, -0x1p-148f, 0x3p-149f}, tiny);
  farthest_vertex(pose, {0x1p125f, -0x1p126f, 0x3p125f}, huge);
  EXPECT_EQ(tiny.triangle, unit.triangle);
  EXPECT_EQ(huge.triangle, unit.triangle);
  EXPECT_EQ(tiny.corner, unit.corner);
  EXPECT_EQ(huge.corner, unit.corner);
}

TEST(FarthestVertex, AllocatesNothingInAReservedPose) {
  Pose pose(*build_model(test::make_limb(24, 10, 5).view()));
  pose.reserve();
  FarthestVertex found;
  const std::size_t before = test::allocation_count();
  farthest_vertex(pose, {1, 0, 0}, found);
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace pelt
