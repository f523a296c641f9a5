#include <pelt/self.hpp>

#include "body.hpp"
#include "support/pinned_shapes.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

TEST(SelfCollide, ReportsClosedSurfacesAndModelsOfOneTriangleAsApart) {
  for (const auto& [vertex_count, triangles] :
       {std::pair{3u, std::vector<Triangle>{{0, 1, 2}}}, std::pair{4u, tetrahedron()}}) {
    Body body(make_pinned(vertex_count, triangles));
    const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    ASSERT_TRUE(body.pose.set_palette(pin(std::span(corners).first(vertex_count))));
    std::vector<Contact> contacts;
    const SelfStats stats = self_collide(body.pose, body.filter, body.scratch, contacts);
    EXPECT_TRUE(contacts.empty());
    EXPECT_FALSE(stats.cut_short);
    EXPECT_FALSE(self_intersects(body.pose, body.filter, body.scratch));
  }
}

/// A sheet of two triangles whose common edge is written with 0.0 in one and -0.0 in the other.
TEST(SelfCollide, EdgesWithZerosOfBothSignsAreShared) {
  Body body(make_pinned(6, {{0, 1, 2}, {3, 4, 5}}));
  Shape& shape = body.shape;
  shape.rest_positions = {{0.0F, 0, 0},  {0.0F, 1, 0},  {1, 0, 0},
                          {-0.0F, 0, 0}, {-0.0F, 1, 0}, {-1, 0, 0}};
  Body sheet(shape);
  EXPECT_TRUE(self_contacts_of(sheet.pose, sheet.filter, sheet.scratch).empty());
  shape.rest_positions[3].x = shape.rest_positions[4].x = -1e-6F;
  Body apart(shape);
  EXPECT_TRUE(self_contacts_of(apart.pose, apart.filter, apart.scratch).empty());
  shape.rest_positions[3].x = shape.rest_positions[4].x = 1e-6F;
  Body across(shape);
  EXPECT_EQ(self_contacts_of(across.pose, across.filter, across.scratch).size(), 1u);
}

/// Bodies with contacts of neighbours and of others, some of which a filter leaves out.
template <typename Test>
void on_touching_bodies(std::uint64_t seed, const Test& test) {
  Random random(seed);
  for (int round = 0; round < 9; ++round) {
    Shape shape = round % 3 == 0   ? make_limb(30, 9, 6)
                  : round % 3 == 1 ? make_soup(random, 200, 6, 4, Weights::random)
                                   : make_grid_soup(random, 150, 5, 6);
    std::vector<std::uint8_t> takes_part;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t)
      takes_part.push_back(random.chance(0.8));
    Body body(shape, {.rings = random.index(2), .takes_part = takes_part});
    std::vector<Matrix4> palette;
    do {
      palette = round % 3 == 0 ? bend_limb(random, 6, 1.6, {})
                               : make_palette(random, 6, Motion::rigid, 0.5);
      ASSERT_TRUE(body.pose.set_palette(palette));
    } while (self_contacts_of(body.pose, body.filter, body.scratch).size() < 20);
    body.scratch = {};
    body.pose = Pose(body.pose.model());
    ASSERT_TRUE(body.pose.set_palette(palette));
    test(body);
  }
}

TEST(SelfCollide, TheFirstContactCostsLess) {
  on_touching_bodies(905, [](Body& body) {
    std::vector<Contact> all;
    const SelfStats stats = self_collide(body.pose, body.filter, body.scratch, all);
    const YesNo first = self_intersects(body.pose, body.filter, body.scratch);
    EXPECT_TRUE(first);
    EXPECT_FALSE(first.cut_short);
    EXPECT_LT(first.triangle_pairs, stats.triangle_pairs / 2);
  });
}

auto work_of(const SelfStats& stats) {
  return std::tuple(stats.node_pairs, stats.triangle_pairs, stats.left_out.total());
}

TEST(SelfCollide, CountsItsWork) {
  on_touching_bodies(907, [](Body& body) {
    std::vector<Contact> contacts;
    const SelfStats cold = self_collide(body.pose, body.filter, body.scratch, contacts);
    EXPECT_GE(cold.posed_vertices, body.shape.rest_positions.size() / 3);
    EXPECT_GT(cold.refits, 0u);
    EXPECT_GT(cold.node_pairs, 0u);
    EXPECT_GE(cold.triangle_pairs, contacts.size() + cold.left_out.total());
    const SelfStats warm = self_collide(body.pose, body.filter, body.scratch, contacts);
    EXPECT_EQ(work_of(warm), work_of(cold));
    EXPECT_EQ(warm.posed_vertices, 0u);
  });
}

TEST(SelfCollide, RefusesTheFilterOfAnotherModel) {
  Body body(make_limb(12, 8, 3)), other(make_limb(12, 8, 3));
  std::vector<Contact> contacts;
  EXPECT_DEATH(self_collide(body.pose, other.filter, body.scratch, contacts),
               "self_collide: the filter is of another model");
  EXPECT_DEATH(self_intersects(body.pose, other.filter, body.scratch),
               "self_intersects: the filter is of another model");
}

}  // namespace
}  // namespace pelt::test
