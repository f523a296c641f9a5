/// With reserved poses and scratch, no query allocates, not even the first.

#include <pelt/collide.hpp>

#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace pelt {
namespace {

using test::Motion;
using test::Random;
using test::Shape;

/// Triangles around one vertex, each twice as large as the one before: the deepest possible tree.
Shape make_fan_of_all_sizes() {
  Shape fan;
  fan.influences_per_vertex = 1;
  for (int size = -55; size <= 55; ++size)
    for (std::uint32_t i = 0; i < 20; ++i) {
      const float length = std::ldexp(1.0f, size), width = length / static_cast<float>(2 + i);
      const auto first = static_cast<std::uint32_t>(fan.rest_positions.size());
      for (const Vec3& p : {Vec3{length, 0, width}, Vec3{length, width, 0}, Vec3{width, width, 0}})
        fan.rest_positions.push_back(p);
      fan.triangles.push_back({first, first + 1, first + 2});
    }
  fan.joints.resize(fan.rest_positions.size(), 0);
  fan.weights.resize(fan.rest_positions.size(), 1);
  return fan;
}

/// Two poses of one model, and all queries of them.
struct Twins {
  explicit Twins(const Shape& shape)
      : a(*build_model(shape.view())), b(a.model()), positions(shape.rest_positions.size()) {
    contacts.reserve(kMaxContacts);
  }

  void reserve(std::size_t contact_count) {
    a.reserve();
    b.reserve();
    scratch.reserve(contact_count);
  }

  /// Runs all queries in a new pose. Returns the number of allocations.
  std::size_t ask(const std::vector<Matrix4>& palette_a, const std::vector<Matrix4>& palette_b,
                  std::initializer_list<std::uint32_t> limits = {UINT32_MAX, kFewContacts, 1}) {
    const std::size_t before = test::allocation_count();
    for (const std::uint32_t max_contacts : limits) {
      EXPECT_TRUE(a.set_palette(palette_a));
      EXPECT_TRUE(b.set_palette(palette_b));
      contacts.clear();
      stats += collide(a, b, scratch, contacts, {max_contacts});
      EXPECT_EQ(intersects(a, b, scratch).answer, !contacts.empty());
    }
    posed_vertices(a, positions);
    return test::allocation_count() - before;
  }

  static constexpr std::uint32_t kMaxContacts = 1 << 20, kFewContacts = 20;

  Pose a, b;
  std::vector<Vec3> positions;
  Scratch scratch;
  std::vector<Contact> contacts;
  QueryStats stats;
};

/// Limbs, soups and a fan: near each other, in the same position, and flattened.
template <typename Body>
void for_all_twins(Random& random, const Body& body) {
  const Shape limb = test::make_limb(60, 20, 5), fan = make_fan_of_all_sizes();
  for (const double distance : {0.3, 0.0})
    body(limb, test::bend_limb(random, 5, 0.3, {}),
         test::bend_limb(random, 5, 0.3, random.point(distance)));
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away}) {
    const Shape soup = test::make_soup(random, 200, 20, 4, test::Weights::random);
    const auto palette = test::make_palette(random, 20, motion, 1);
    body(soup, palette, palette);
    body(soup, palette, test::make_palette(random, 20, motion, 1));
  }
  body(fan, std::vector<Matrix4>(1), std::vector<Matrix4>(1));
}

TEST(Reserve, NoQueryAllocatesFromTheFirstOn) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(80);
    std::uint64_t triangle_pairs = 0;
    for_all_twins(random, [&](const Shape& shape, const auto& palette_a, const auto& palette_b) {
      Twins twins(shape);
      twins.reserve(Twins::kMaxContacts);
      EXPECT_EQ(twins.ask(palette_a, palette_b), 0u);
      EXPECT_EQ(twins.ask(palette_b, palette_a), 0u);
      EXPECT_LT(twins.contacts.size(), Twins::kMaxContacts);
      triangle_pairs += twins.stats.triangle_pairs;
    });
    EXPECT_GT(triangle_pairs, 100'000u);
  });
}

TEST(Reserve, QueriesThatAreToldToStopNeedRoomForNoMore) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(82);
    std::size_t stopped = 0;
    for_all_twins(random, [&](const Shape& shape, const auto& palette_a, const auto& palette_b) {
      Twins twins(shape);
      twins.reserve(Twins::kFewContacts);
      EXPECT_EQ(twins.ask(palette_a, palette_b, {Twins::kFewContacts, 1}), 0u);
      stopped += twins.stats.cut_short;
    });
    EXPECT_GT(stopped, 5u);
  });
}

TEST(Reserve, ForgetsWhatWasOpenedAndChangesNoAnswer) {
  Random random(81);
  std::size_t touching = 0;
  for_all_twins(random, [&](const Shape& shape, const auto& palette_a, const auto& palette_b) {
    Twins twins(shape), reserved(shape);
    EXPECT_GT(twins.ask(palette_a, palette_b), 0u) << "the counter must count";
    reserved.ask(palette_b, palette_a);
    reserved.reserve(Twins::kMaxContacts);
    EXPECT_EQ(reserved.ask(palette_a, palette_b), 0u);
    std::vector<Contact> expected, found;
    collide(twins.a, twins.b, twins.scratch, expected);
    collide(reserved.a, reserved.b, reserved.scratch, found);
    EXPECT_EQ(found, expected);
    touching += !expected.empty();
  });
  EXPECT_GT(touching, 5u);
}

}  // namespace
}  // namespace pelt
