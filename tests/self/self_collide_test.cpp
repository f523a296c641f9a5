#include <pelt/self.hpp>

#include "body.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/pinned_shapes.hpp"
#include "surface_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace pelt::test {
namespace {

/// Bends a limb until it folds onto itself.
void fold(Random& random, Body& body) {
  ASSERT_TRUE(body.pose.set_palette(
      bend_limb(random, body.shape.joint_count, random.uniform(0.2, 1.6), {})));
}

TEST(SelfCollide, EqualsBruteForceOnFoldedLimbs) {
  on_each_instruction_set([](InstructionSet) {
    Random random(900);
    Body body(make_limb(30, 9, 6));
    int touching = 0, apart = 0;
    for (int round = 0; round < 40; ++round) {
      fold(random, body);
      const auto expected = brute_force_self(body.shape, body.pose);
      ASSERT_EQ(self_contacts_of(body.pose, body.filter, body.scratch), expected)
          << "round " << round;
      ASSERT_EQ(self_intersects(body.pose, body.filter, body.scratch).answer, !expected.empty());
      ++(expected.empty() ? apart : touching);
    }
    EXPECT_GT(touching, 10);
    EXPECT_GT(apart, 1);
  });
}

TEST(SelfCollide, EqualsBruteForceOnSoupsUnderAnyAffineJoints) {
  on_each_instruction_set([](InstructionSet) {
    Random random(901);
    std::size_t contacts = 0;
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
        for (const std::uint32_t influences : {1u, 4u}) {
          Body body(make_soup(random, 150, 6, influences, weights));
          ASSERT_TRUE(body.pose.set_palette(make_palette(random, 6, motion, 1)));
          const auto expected = brute_force_self(body.shape, body.pose);
          ASSERT_EQ(self_contacts_of(body.pose, body.filter, body.scratch), expected);
          contacts += expected.size();
        }
    EXPECT_GT(contacts, 10'000u);
  });
}

/// Surfaces of neighbours with vertices anywhere on a small grid: folds by a half turn, duplicates,
/// collapsed fans, T-joints.
TEST(SelfCollide, EqualsBruteForceWherePosedVerticesCoincide) {
  const std::pair<std::uint32_t, std::vector<Triangle>> surfaces[] = {
      {4, tetrahedron()}, {6, octahedron()}, {35, torus(7, 5)}};
  Random random(902);
  std::size_t contacts = 0, pairs = 0;
  for (int round = 0; round < 300; ++round) {
    const auto& [vertex_count, triangles] = surfaces[round % 3];
    Body body(make_pinned(vertex_count, triangles));
    const std::uint32_t size = 2 + random.index(5);
    std::vector<Vec3> positions(vertex_count);
    for (Vec3& p : positions)
      p = {static_cast<float>(random.index(size)), static_cast<float>(random.index(size)),
           static_cast<float>(random.index(3))};
    ASSERT_TRUE(body.pose.set_palette(pin(positions)));
    const auto expected = brute_force_self(body.shape, body.pose);
    ASSERT_EQ(self_contacts_of(body.pose, body.filter, body.scratch), expected);
    contacts += expected.size();
    pairs += triangles.size() * (triangles.size() - 1) / 2;
  }
  EXPECT_GT(contacts, pairs / 10);
  EXPECT_LT(contacts, pairs * 9 / 10);
}

TEST(SelfCollide, AllTrianglesShareOneVertex) {
  Random random(903);
  for (const std::uint32_t size : {24u, 25u, 600u}) {
    Shape shape;
    shape.influences_per_vertex = 1;
    add_fan(random, shape, size, false, {});
    Body body(shape);
    EXPECT_TRUE(self_contacts_of(body.pose, body.filter, body.scratch).empty());
    Matrix4 flat;
    flat.m[0] = 0;
    ASSERT_TRUE(body.pose.set_palette(std::vector<Matrix4>(1, flat)));
    const auto expected = brute_force_self(shape, body.pose);
    EXPECT_GT(expected.size(), size * size / 8);
    EXPECT_EQ(self_contacts_of(body.pose, body.filter, body.scratch), expected);
  }
}

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

/// A limb whose corners are split into vertices with equal influences, some of which move apart.
struct SplitLimb {
  explicit SplitLimb(Random& random) : shape(make_limb(6, 6, 2)) {
    split_corners(random, shape, 0.1, 0);
    for (const Vec3& rest : shape.rest_positions) {
      const auto coordinate = [&] { return static_cast<float>(random.index(4)); };
      const bool moves = random.chance(0.5);
      positions.push_back(moves ? Vec3{coordinate(), coordinate(), coordinate()} : rest);
    }
  }

  Shape shape;
  std::vector<Vec3> positions;
};

/// Returns the number of contacts.
std::size_t expect_brute_force(const Shape& shape, Pose& pose) {
  const auto expected = brute_force_self(shape, pose);
  Scratch scratch;
  EXPECT_EQ(self_contacts_of(pose, *build_self_filter(pose.model()), scratch), expected);
  return expected.size();
}

TEST(SelfCollide, EqualsBruteForceWhereVerticesThatAreNotWeldedMoveApart) {
  Random random(906);
  std::size_t contacts = 0, apart = 0;
  for (int round = 0; round < 60; ++round) {
    const SplitLimb limb(random);
    apart += !Pose(*build_model(limb.shape.view())).set_vertices(limb.positions);
    Pose pose(*build_model(limb.shape.view(), {.weld = false}));
    ASSERT_TRUE(pose.set_vertices(limb.positions));
    contacts += expect_brute_force(limb.shape, pose);
  }
  std::printf("seed 906: %zu contacts, %zu limbs that do not fit welded models\n", contacts, apart);
  EXPECT_GT(contacts, 1000u);
  EXPECT_GT(apart, 50u);
}

TEST(SelfCollide, EqualsBruteForceWhereOffsetsMoveVerticesApart) {
  Random random(907);
  std::size_t contacts = 0;
  for (int round = 0; round < 60; ++round) {
    const SplitLimb limb(random);
    const std::vector<float> caps(limb.positions.size(), 4);
    SkinnedMeshView view = limb.shape.view();
    view.offset_caps = caps;
    Pose pose(*build_model(view));
    ASSERT_TRUE(pose.set_offsets(limb.positions));
    contacts += expect_brute_force(limb.shape, pose);
  }
  std::printf("seed 907: %zu contacts\n", contacts);
  EXPECT_GT(contacts, 1000u);
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

TEST(SelfCollide, StopsAtTheLimitWithPairsOfTheFullAnswer) {
  on_each_instruction_set([](InstructionSet) {
    on_touching_bodies(904, [](Body& body) {
      const auto all = self_contacts_of(body.pose, body.filter, body.scratch);
      const auto count = static_cast<std::uint32_t>(all.size());
      ASSERT_GT(count, 10u);
      for (const std::uint32_t limit : {0u, 1u, 2u, 7u, 8u, 9u, count / 2, count - 1, count}) {
        std::vector<Contact> found;
        const SelfStats stats =
            self_collide(body.pose, body.filter, body.scratch, found, {.max_contacts = limit});
        EXPECT_EQ(found.size(), limit);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        EXPECT_TRUE(std::includes(all.begin(), all.end(), found.begin(), found.end()));
        EXPECT_TRUE(stats.cut_short || limit == count) << limit << " of " << count;
      }
      for (const std::uint32_t limit : {count + 1, UINT32_MAX}) {
        std::vector<Contact> found;
        const SelfStats stats =
            self_collide(body.pose, body.filter, body.scratch, found, {.max_contacts = limit});
        EXPECT_FALSE(stats.cut_short);
        EXPECT_EQ(found, all);
      }
    });
  });
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

TEST(SelfCollide, AppendsAscendingContacts) {
  on_touching_bodies(906, [](Body& body) {
    const auto all = self_contacts_of(body.pose, body.filter, body.scratch);
    const Contact before[] = {{7, 3}, {9, 9}};
    std::vector<Contact> contacts(std::begin(before), std::end(before));
    self_collide(body.pose, body.filter, body.scratch, contacts);
    ASSERT_EQ(contacts.size(), all.size() + 2);
    EXPECT_TRUE(std::equal(std::begin(before), std::end(before), contacts.begin()));
    EXPECT_TRUE(std::equal(all.begin(), all.end(), contacts.begin() + 2));
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_LT(all[i].triangle_a, all[i].triangle_b);
      EXPECT_TRUE(i == 0 || all[i - 1] < all[i]);
    }
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

/// The answer does not depend on the nodes that other queries have opened.
TEST(SelfCollide, GivesTheSameAnswerAfterOtherQueries) {
  on_touching_bodies(908, [](Body& body) {
    const auto expected = self_contacts_of(body.pose, body.filter, body.scratch);
    Pose fresh(body.pose.model()), other(body.pose.model());
    Random random(9080);
    const auto palette = make_palette(random, 6, Motion::rigid, 0.5);
    for (Pose* pose : {&body.pose, &fresh, &other}) ASSERT_TRUE(pose->set_palette(palette));
    std::vector<Contact> ignored;
    collide(body.pose, other, body.scratch, ignored);
    EXPECT_EQ(self_contacts_of(body.pose, body.filter, body.scratch),
              self_contacts_of(fresh, body.filter, body.scratch));
    EXPECT_FALSE(expected.empty());
  });
}

TEST(SelfCollide, AllocatesNothingWhenWarm) {
  on_touching_bodies(909, [](Body& body) {
    std::vector<Contact> contacts;
    self_collide(body.pose, body.filter, body.scratch, contacts);
    contacts.clear();
    const std::size_t before = allocation_count();
    self_collide(body.pose, body.filter, body.scratch, contacts);
    EXPECT_TRUE(self_intersects(body.pose, body.filter, body.scratch));
    EXPECT_EQ(allocation_count(), before);
  });
}

/// Returns the number of allocations of the first queries of reserved memory.
std::size_t allocations_when_reserved(const Shape& shape, const std::vector<Matrix4>& palette,
                                      std::uint32_t limit, std::uint32_t rings) {
  Body body(shape, {.rings = rings});
  std::vector<Contact> contacts;
  const std::size_t room = std::min<std::size_t>(limit, 1 << 20);
  contacts.reserve(room);
  body.pose.reserve();
  body.scratch.reserve(room, 0, body.filter.scratch_size());
  const std::size_t before = allocation_count();
  EXPECT_TRUE(body.pose.set_palette(palette));
  self_collide(body.pose, body.filter, body.scratch, contacts, {.max_contacts = limit});
  EXPECT_TRUE(self_intersects(body.pose, body.filter, body.scratch) || contacts.empty());
  return allocation_count() - before;
}

TEST(SelfCollide, AllocatesNothingWhenReserved) {
  Random random(910);
  Shape disc;
  disc.influences_per_vertex = 1;
  add_fan(random, disc, 600, true, {});
  disc.triangles.push_back({0, 0, 0});
  Matrix4 flat;
  flat.m[0] = 0;
  for (const std::uint32_t limit : {1u, 20u, UINT32_MAX})
    for (const std::uint32_t rings : {0u, 1u, 3u, 64u}) {
      SCOPED_TRACE(testing::Message() << "limit " << limit << ", rings " << rings);
      EXPECT_EQ(allocations_when_reserved(make_limb(40, 9, 6), bend_limb(random, 6, 1.5, {}), limit,
                                          rings),
                0u);
      EXPECT_EQ(
          allocations_when_reserved(make_grid_soup(random, 200, 4, 6),
                                    make_palette(random, 6, Motion::rigid, 0.5), limit, rings),
          0u);
      if (rings < 2 && limit < UINT32_MAX) {
        EXPECT_EQ(allocations_when_reserved(disc, {flat}, limit, rings), 0u);
      }
    }
  EXPECT_EQ(allocations_when_reserved(make_pinned(3, {{0, 0, 0}, {0, 1, 2}, {1, 2, 2}}),
                                      pin(std::vector<Vec3>(3)), 20, 3),
            0u);
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
