#include <pelt/inside.hpp>

#include "pose/pose.hpp"
#include "prism_volume.hpp"
#include "support/closed_body.hpp"
#include "support/closed_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The volume of the intersection, computed in both orders.
double common_volume(const Shape& shape_a, const Shape& shape_b) {
  Body a(shape_a), b(shape_b);
  const Volume volume = intersection_of(a, b), exchanged = intersection_of(b, a);
  EXPECT_LE(std::abs(volume.value - exchanged.value), volume.error + exchanged.error);
  EXPECT_LT(volume.error, 1e-12);
  return volume.value;
}

TEST(Volume, IsThatOfKnownBodies) {
  Body cube(make_cube(1.5f, {1, 2, 3}));
  EXPECT_NEAR(volume_of(cube).value, 27, volume_of(cube).error);
  EXPECT_LT(volume_of(cube).error, 1e-12);
  Body sphere(make_sphere(2, 5));
  EXPECT_NEAR(volume_of(sphere).value, 4.0 / 3 * kPi * 8, 0.1);
}

TEST(Volume, IsNegativeInAMirroredPose) {
  Body cube(make_cube(1, {0, 0, 0}));
  Matrix4 mirror;
  mirror.m[0] = -1;
  cube.set({mirror});
  EXPECT_NEAR(volume_of(cube).value, -8, 1e-12);
}

TEST(IntersectionVolume, IsThatOfBoxes) {
  const Shape cube = make_cube(1, {0, 0, 0});
  EXPECT_NEAR(common_volume(cube, make_cube(1, {0.5f, 0.25f, 0.125f})), 1.5 * 1.75 * 1.875, 1e-12);
  EXPECT_NEAR(common_volume(cube, make_cube(1, {0.5f, 0, 0})), 1.5 * 4, 1e-12) << "coplanar faces";
  EXPECT_NEAR(common_volume(cube, cube), 8, 1e-12) << "all faces coincide";
  EXPECT_NEAR(common_volume(cube, cut(cube)), 8, 1e-12);
  EXPECT_NEAR(common_volume(cut(cube), make_cube(1, {1, 1, 1})), 1, 1e-12);
}

TEST(IntersectionVolume, IsThatOfTheInnerBody) {
  const Shape cube = make_cube(1, {0, 0, 0});
  EXPECT_NEAR(common_volume(cube, make_cube(0.5f, {0.25f, 0.25f, 0})), 1, 1e-12);
  EXPECT_NEAR(common_volume(cube, make_cube(0.5f, {0.5f, 0.5f, 0.5f})), 1, 1e-12) << "at a corner";
  Body sphere(make_sphere(0.5f, 3));
  EXPECT_NEAR(common_volume(cube, sphere.shape), volume_of(sphere).value, 1e-12);
}

TEST(IntersectionVolume, IsZeroOfBodiesThatOnlyTouch) {
  const Shape cube = make_cube(1, {0, 0, 0});
  EXPECT_EQ(common_volume(cube, make_cube(1, {5, 0, 0})), 0) << "apart";
  EXPECT_NEAR(common_volume(cube, make_cube(1, {2, 0, 0})), 0, 1e-12) << "face to face";
  EXPECT_NEAR(common_volume(cube, make_cube(1, {2, 0.5f, 0.25f})), 0, 1e-12) << "face on face";
  EXPECT_NEAR(common_volume(cube, make_cube(1, {2, 2, 0})), 0, 1e-12) << "edge to edge";
  EXPECT_NEAR(common_volume(cube, make_cube(1, {2, 2, 2})), 0, 1e-12) << "corner to corner";
}

TEST(IntersectionVolume, IsThatOfSpheres) {
  Body a(make_sphere(1, 5)), b(make_sphere(1, 5));
  b.move({1, 0, 0});
  // Two caps of height 1/2.
  EXPECT_NEAR(intersection_of(a, b).value, 2 * kPi * 0.25 * (3 - 0.5) / 3, 0.01);
}

TEST(IntersectionVolume, CountsWindingNumbers) {
  const Shape cube = make_cube(1, {0, 0, 0}), part = make_cube(1, {1, 0, 0});
  const Shape apart = make_cube(0.75f, {-1, 0, 0}), within = make_cube(0.875f, {1, 0, 0});
  EXPECT_NEAR(common_volume(cube, together(part, apart)), 4 + 0.75 * 1.5 * 1.5, 1e-12);
  const Shape twice = together(part, within);
  EXPECT_NEAR(common_volume(cube, twice), 4 + 0.875 * 1.75 * 1.75, 1e-12);
  EXPECT_NEAR(common_volume(twice, twice), 8 + 3 * 1.75 * 1.75 * 1.75, 1e-12);
}

TEST(IntersectionVolume, IsThatOfPrismsBelowTriangles) {
  Random random(41);
  Body a(make_limb(24, 13, 4)), b(make_limb(24, 11, 4));
  int hits = 0;
  for (int i = 0; i < 30; ++i) {
    a.set(bend_limb(random, 4, i % 3 == 0 ? 1.2 : 0.5, {0, 0, 0}));
    b.set(bend_limb(random, 4, 0.5, {0.09f, 0.05f, 0.06f}));
    const PrismVolume<double> prisms_a(a.posed(), a.shape.triangles);
    const PrismVolume<double> prisms_b(b.posed(), b.shape.triangles);
    const double expected = prisms_a.of_intersection(prisms_b);
    const Volume found = intersection_of(a, b);
    EXPECT_NEAR(found.value, expected, 1e-11);
    EXPECT_LT(found.error, 1e-12);
    hits += expected > 1e-6;
  }
  EXPECT_GT(hits, 15);
}

/// The number of vertices in all open nodes.
std::uint64_t opened_vertices(Pose& pose) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  std::uint64_t count = 0;
  for (std::uint32_t n = 0; posed.opened && n < posed.tree.nodes.size(); ++n)
    if (posed.opened[n] != nullptr) count += posed.tree.nodes[n].vertex_count;
  return count;
}

TEST(IntersectionVolume, CountsItsWorkAndPosesOnlyWhatIsNear) {
  Body a(make_sphere(1, 6)), b(make_sphere(1, 6));
  b.move({1.99f, 0, 0});
  Scratch scratch;
  Volume found;
  const QueryStats work = intersection_volume(a.pose, b.pose, scratch, found);
  EXPECT_GT(found.value, 0);
  EXPECT_LT(found.value, 1e-3);
  EXPECT_EQ(work.posed_vertices, opened_vertices(a.pose) + opened_vertices(b.pose));
  EXPECT_LT(work.posed_vertices,
            (a.shape.rest_positions.size() + b.shape.rest_positions.size()) / 8);
  EXPECT_GT(work.node_pairs, 0u);
  EXPECT_GT(work.refits, 0u);
  EXPECT_GT(work.triangle_pairs, 0u);
}

TEST(IntersectionVolumeDeathTest, AbortsOnSurfacesThatAreNotClosed) {
  Shape open = make_cube(1, {0, 0, 0});
  open.triangles.pop_back();
  Body a(open), b(make_cube(1, {0, 0, 0}));
  EXPECT_DEATH(intersection_of(a, b), "intersection_volume: a surface is not closed");
  EXPECT_DEATH(volume_of(a), "volume: the surface is not closed");
}

}  // namespace
}  // namespace pelt::test
