/// With reserved poses and scratch, no query allocates, not even the first: for the deepest tree,
/// and for the most pairs of nodes that wait. Other models are in query/query_contract_test.cpp.

#include <pelt/collide.hpp>

#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pelt {
namespace {

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

/// Returns the number of allocations of all queries of two poses of a model, after reserving.
std::size_t allocations(const Shape& shape, const std::vector<Matrix4>& palette_a,
                        const std::vector<Matrix4>& palette_b) {
  constexpr std::uint32_t kMaxContacts = 1 << 20;
  Pose a(*build_model(shape.view())), b(a.model());
  Scratch scratch;
  std::vector<Contact> contacts;
  std::vector<Vec3> positions(shape.rest_positions.size());
  contacts.reserve(kMaxContacts);
  a.reserve(), b.reserve(), scratch.reserve(kMaxContacts);
  const std::size_t before = test::allocation_count();
  for (const std::uint32_t max_contacts : {UINT32_MAX, 20u, 1u}) {
    EXPECT_TRUE(a.set_palette(palette_a) && b.set_palette(palette_b));
    contacts.clear();
    EXPECT_GT(collide(a, b, scratch, contacts, {max_contacts}).triangle_pairs, 0u);
    EXPECT_TRUE(intersects(a, b, scratch));
  }
  posed_vertices(a, positions);
  return test::allocation_count() - before;
}

TEST(Reserve, NoQueryAllocatesFromTheFirstOn) {
  const Shape limb = test::make_limb(60, 20, 5), fan = make_fan_of_all_sizes();
  test::on_each_instruction_set([&](InstructionSet) {
    Random random(80);
    const auto bent = test::bend_limb(random, 5, 0.3, {});
    EXPECT_EQ(allocations(limb, bent, bent), 0u);
    EXPECT_EQ(allocations(limb, bent, test::bend_limb(random, 5, 0.3, {0.05f, 0, 0})), 0u);
    EXPECT_EQ(allocations(fan, std::vector<Matrix4>(1), std::vector<Matrix4>(1)), 0u);
  });
  EXPECT_GT(test::allocation_count(), 0u) << "the counter must count";
}

}  // namespace
}  // namespace pelt
