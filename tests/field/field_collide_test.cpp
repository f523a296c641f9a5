#include <pelt/bounds.hpp>

#include "collide/moving_bodies.hpp"
#include "field/fields.hpp"
#include "support/animated_character.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"

namespace pelt {
namespace {

using test::make_hills;
using test::make_plain;
using test::Random;
using test::Shape;
using test::Weights;

std::vector<Vec3> posed(const Pose& pose) {
  std::vector<Vec3> positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

std::vector<Contact> contacts_of(Pose& pose, const HeightField& field, Scratch& scratch) {
  std::vector<Contact> contacts;
  collide(pose, field, scratch, contacts);
  return contacts;
}

/// Compares the query with brute force. Returns the number of contacts.
std::size_t expect_as_brute_force(Pose& pose, const Shape& shape, const HeightField& field,
                                  Scratch& scratch) {
  const auto expected = test::brute_force(field, shape.triangles, posed(pose));
  EXPECT_EQ(contacts_of(pose, field, scratch), expected);
  EXPECT_EQ(intersects(pose, field, scratch).answer, !expected.empty());
  return expected.size();
}

/// A soup with vertices at vertices of the field, or on its edges, diagonals and planes.
Shape make_soup_on_grid(Random& random, std::uint32_t triangle_count, std::uint32_t side) {
  Shape soup = test::make_soup(random, triangle_count, 1, 1, Weights::one_joint);
  for (Vec3& p : soup.rest_positions) {
    const auto whole = [&] { return static_cast<float>(random.index(side)); };
    const float along = random.chance(0.5) ? 0.5f : 0.0f;
    p = {whole(), 0, whole()};
    switch (random.index(5)) {
      case 0:  // on an edge along x
        p.x += along;
        break;
      case 1:  // on a diagonal
        p.x += along, p.z += along;
        break;
      case 2:  // above or below
        p.y = random.chance(0.5) ? 1.0f : -0.25f;
        break;
      case 3:  // above by the least amount
        p.y = 0x1p-149f;
        break;
      default:  // a vertex
        break;
    }
  }
  return soup;
}

TEST(FieldCollide, TouchingCountsOnFlatFieldsOnEachTarget) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(702);
    Scratch scratch;
    std::size_t contacts = 0;
    for (int round = 0; round < 10; ++round) {
      const HeightField field = make_plain(9, 9, {}, 1).build();
      const Shape soup = make_soup_on_grid(random, 60, 12);
      Pose pose(*build_model(soup.view()));
      contacts += expect_as_brute_force(pose, soup, field, scratch);
    }
    EXPECT_GT(contacts, 5000u);
  });
}

TEST(FieldCollide, BodiesBelowOrBesideTheFieldTouchNothing) {
  Random random(703);
  const Shape limb = test::make_limb(16, 8, 4);
  Pose pose(*build_model(limb.view()));
  Scratch scratch;
  const HeightField field = make_plain(40, 40, {-4, 0, -4}, 0.2f).build();
  for (const Vec3& place : {Vec3{0, -5, 0}, Vec3{0, 5, 0}, Vec3{20, 0, 0}, Vec3{0, 0, -20}}) {
    ASSERT_TRUE(pose.set_palette(test::bend_limb(random, 4, 0.3, place)));
    std::vector<Contact> contacts;
    const QueryStats stats = collide(pose, field, scratch, contacts);
    EXPECT_TRUE(contacts.empty());
    EXPECT_EQ(stats.posed_vertices, 0u);
  }
}

TEST(FieldCollide, LargeTrianglesIntersectTheCellsUnderThem) {
  Random random(704);
  Shape roof = test::make_soup(random, 4, 1, 1, Weights::one_joint);
  for (Vec3& p : roof.rest_positions) p = {p.x * 30, p.y, p.z * 30};
  Pose pose(*build_model(roof.view()));
  Scratch scratch;
  const HeightField field = make_hills(random, 150, 130, {-30, 0, -26}, 0.4f, 2, 0).build();
  EXPECT_GT(expect_as_brute_force(pose, roof, field, scratch), 100u);
}

/// With 4,096 x 4,096 vertices, the work equals that for a field that ends around the limb.
TEST(FieldCollide, WorkDoesNotGrowWithTheField) {
  Random random(706);
  const Shape limb = test::make_limb(40, 12, 5);
  Scratch scratch;
  std::vector<QueryStats> stats;
  std::size_t contacts = 0;
  for (const std::uint32_t side : {64u, 4096u}) {
    Pose pose(*build_model(limb.view()));
    const float first = -0.125f * static_cast<float>(side / 2);
    const HeightField field = make_plain(side, side, {first, 0.25f, first}, 0.125f).build();
    std::vector<Contact> found;
    stats.push_back(collide(pose, field, scratch, found));
    contacts = found.size();
  }
  EXPECT_GT(contacts, 10u);
  EXPECT_EQ(stats[0].node_pairs, stats[1].node_pairs);
  EXPECT_EQ(stats[0].posed_vertices, stats[1].posed_vertices);
  EXPECT_EQ(stats[0].triangle_pairs, stats[1].triangle_pairs);
}

}  // namespace
}  // namespace pelt

// A moving character against a height field, against the exact test of all pairs of triangles.
namespace pelt::test {
namespace {

/// A foot that goes through a thin bridge from one frame to the next.
TEST(MovingField, FindsWhatNoEndOfTheStepShows) {
  Body limb(make_limb(10, 6, 3));
  const auto at_height = [](float y) {
    std::vector<Matrix4> palette(3);
    for (Matrix4& m : palette) m.m[13] = y;
    return palette;
  };
  limb.move(at_height(0.5f), at_height(-2));
  const HeightField field = make_plain(6, 6, {-1, 0, -1}, 0.4f).build();
  Scratch scratch;
  EXPECT_FALSE(intersects(limb.from, field, scratch));
  EXPECT_FALSE(intersects(limb.to, field, scratch));
  std::vector<MovingContact> contacts;
  collide(limb.step(), field, scratch, contacts);
  EXPECT_GT(contacts.size(), 10u);
}

}  // namespace
}  // namespace pelt::test

// Real characters that walk on generated terrain.
namespace pelt {
namespace {

using test::Random;

using SharedFields = test::OfSharedModels<>;

TEST_P(SharedFields, EqualBruteForce) {
  Pose& pose = character->pose;
  Random random(710);
  Scratch scratch;
  std::vector<Vec3> positions(pose.model().vertex_count());
  std::size_t hits = 0;
  const asset::Clip& clip = character->asset.clips.front();
  for (int step = 0; step < 3; ++step) {
    character->move(&clip, clip.duration * static_cast<float>(step) / 3);
    posed_vertices(pose, positions);
    const Box box = test::bounds_of(pose).box;
    const float size = box.high.y - box.low.y, spacing = size / 14;
    const Vec3 origin = {(box.low.x + box.high.x) / 2 - 12 * spacing, box.low.y + size / 20,
                         (box.low.z + box.high.z) / 2 - 12 * spacing};
    const HeightField field =
        test::make_hills(random, 25, 25, origin, spacing, size / 10, 0.01).build();
    const auto expected = test::brute_force(field, character->asset.triangles, positions);
    std::vector<Contact> contacts;
    collide(pose, field, scratch, contacts);
    EXPECT_EQ(contacts, expected);
    hits += contacts.size();
  }
  EXPECT_GT(hits, 50u);
}

INSTANTIATE_TEST_SUITE_P(Models, SharedFields,
                         testing::Values("human.glb", "knight.glb", "fox_khronos.glb"));

}  // namespace
}  // namespace pelt
