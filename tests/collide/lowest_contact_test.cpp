/// The lowest contact of two poses, against all contacts.
#include "collide/collide_trees.hpp"

#include "contacts_of.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

namespace pelt {
namespace {

using test::Random;
using test::Shape;

/// The numbers of neighbours are far apart.
Shape with_shuffled_triangles(Random& random, Shape shape) {
  for (std::size_t i = shape.triangles.size(); i > 1; --i)
    std::swap(shape.triangles[i - 1], shape.triangles[random.index(static_cast<std::uint32_t>(i))]);
  return shape;
}

struct Limbs {
  Limbs(const Shape& shape_a, const Shape& shape_b)
      : a(*build_model(shape_a.view())), b(*build_model(shape_b.view())) {}

  void move(Random& random) {
    const double angle_a = random.uniform(-0.6, 0.6), angle_b = random.uniform(-0.6, 0.6);
    ASSERT_TRUE(a.set_palette(test::bend_limb(random, 5, angle_a, {})));
    ASSERT_TRUE(b.set_palette(test::bend_limb(random, 4, angle_b, random.point(0.3))));
  }

  QueryStats find_lowest(std::optional<Contact>& lowest) {
    return lowest_contact(a.detail().posed_tree(), b.detail().posed_tree(), scratch.detail(),
                          lowest);
  }

  std::optional<Contact> lowest() {
    std::optional<Contact> found;
    find_lowest(found);
    return found;
  }

  Pose a, b;
  Scratch scratch;
};

std::optional<Contact> first_of(const std::vector<Contact>& contacts) {
  return contacts.empty() ? std::nullopt : std::optional(contacts.front());
}

TEST(LowestContact, IsTheFirstOfAllContacts) {
  Random random(31);
  const Shape ordered_a = test::make_limb(24, 10, 5), ordered_b = test::make_limb(17, 9, 4);
  const Shape shuffled_a = with_shuffled_triangles(random, ordered_a);
  const Shape shuffled_b = with_shuffled_triangles(random, ordered_b);
  Limbs ordered(ordered_a, ordered_b), shuffled(shuffled_a, shuffled_b);
  int touching = 0, apart = 0;
  for (Limbs* limbs : {&ordered, &shuffled})
    for (int round = 0; round < 100; ++round) {
      limbs->move(random);
      const auto expected = first_of(test::contacts_of(limbs->a, limbs->b, limbs->scratch));
      test::on_each_instruction_set(
          [&](InstructionSet) { ASSERT_EQ(limbs->lowest(), expected) << "round " << round; });
      ++(expected ? touching : apart);
    }
  std::cout << touching << " touching, " << apart << " apart\n";
  EXPECT_GT(touching, 40);
  EXPECT_GT(apart, 40);
}

TEST(LowestContact, TestsFewerTrianglesThanAllContacts) {
  Random random(32);
  Limbs limbs(test::make_limb(40, 16, 5), test::make_limb(40, 16, 4));
  std::uint64_t all = 0, lowest = 0;
  std::optional<Contact> found;
  std::vector<Contact> contacts;
  for (int round = 0; round < 30; ++round) {
    limbs.move(random);
    all += collide(limbs.a, limbs.b, limbs.scratch, contacts).triangle_pairs;
    lowest += limbs.find_lowest(found).triangle_pairs;
  }
  std::cout << "triangle pairs: " << all << " of all contacts, " << lowest << " of the lowest\n";
  EXPECT_LT(2 * lowest, all);
}

TEST(LowestContact, AllocatesNothingWhenWarm) {
  Random random(33);
  Limbs limbs(test::make_limb(24, 10, 5), test::make_limb(17, 9, 4));
  limbs.move(random);
  const auto first = limbs.lowest();
  const std::size_t before = test::allocation_count();
  EXPECT_EQ(limbs.lowest(), first);
  EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace pelt
