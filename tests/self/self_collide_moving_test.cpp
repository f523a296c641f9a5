/// A moving character against itself: against the exact tests of all pairs of its triangles.

#include <pelt/self.hpp>

#include "collide/moving_bodies.hpp"
#include "self/self_brute_force.hpp"
#include "self/surface_shapes.hpp"
#include "self_moving_brute_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {
namespace {

/// A character at both ends of a step, with a filter.
struct SelfBody : Body {
  explicit SelfBody(const Shape& s, const SelfFilterOptions& options = {},
                    const ModelOptions& how = {})
      : Body(s, how), filter(*build_self_filter(from.model(), options)) {}

  std::vector<MovingContact> contacts(const MovingOptions& options = {}) {
    std::vector<MovingContact> found;
    self_collide(step(), filter, scratch, found, options);
    return found;
  }

  SelfFilter filter;
  Scratch scratch;
};

std::vector<MovingContact> all_pairs_of(const Body& body) {
  const auto surface = surface_vertices(body.shape);
  return brute_force_self_moving(body.triangles(), surface_corners(body.shape.triangles, surface));
}

std::vector<Contact> pairs_of(const std::vector<MovingContact>& contacts) {
  std::vector<Contact> pairs;
  for (const MovingContact& c : contacts) pairs.push_back(c.contact);
  return pairs;
}

/// A limb that folds or unfolds.
struct FoldingLimb : SelfBody {
  explicit FoldingLimb(const SelfFilterOptions& options = {})
      : SelfBody(make_limb(16, 6, 5), options) {}

  void fold(Random& random) {
    const double first = random.uniform(0.1, 1.4), last = first + random.uniform(-0.3, 0.3);
    const auto bent = bend_limb(random, 5, first, {});
    move(bent, bend_limb(random, 5, last, {}));
  }
};

/// Vertices on a small grid: neighbours of every kind, cracks, collapsed triangles.
TEST(SelfCollideMoving, EqualsTheExactTestOfAllPairsOnGridSoups) {
  Random random(1842);
  std::size_t contacts = 0, cracked = 0;
  for (const std::uint32_t joints : {1u, 2u}) {
    SelfBody soup(make_grid_soup(random, 30, 3, joints));
    const auto from = make_palette(random, joints, test::Motion::affine, 1);
    soup.move(from, make_palette(random, joints, test::Motion::affine, 1));
    const auto expected = all_pairs_of(soup);
    ASSERT_EQ(soup.contacts(), expected);
    contacts += expected.size();
    cracked += joints == 2 ? expected.size() : 0;
  }
  EXPECT_GT(contacts, 200u);
  EXPECT_GT(cracked, 50u);
}

/// Triangles with the same corners in another order, far above each other, as pairs: the upper one
/// follows joint 1, and has the lower number in every second pair.
Shape make_congruent_pairs(Random& random, std::uint32_t pairs) {
  Shape shape;
  shape.influences_per_vertex = 1;
  shape.joint_count = 2;
  for (std::uint32_t pair = 0; pair < pairs; ++pair) {
    const float x = 4 * static_cast<float>(pair);
    const std::size_t turn = random.index(3);
    for (const std::uint32_t joint : {pair % 2, 1 - pair % 2}) {
      const float z = 100 * static_cast<float>(joint);
      const Vec3 places[] = {{x, 0, z}, {x + 2, 0, z}, {x + 1, 2, z}};
      Triangle corners;
      for (std::size_t corner = 0; corner < 3; ++corner)
        corners[corner] = add_vertex(shape, places[(corner + joint * turn) % 3],
                                     static_cast<std::uint16_t>(joint));
      shape.triangles.push_back(corners);
    }
  }
  return shape;
}

/// If several pairs of features meet at once, the order of the two triangles decides which pair is
/// reported. The places of the triangles in the tree must not matter.
TEST(SelfCollideMoving, NamesFeaturesFromTheLowerTriangle) {
  Random random(1843);
  SelfBody body(make_congruent_pairs(random, 60));
  std::vector<Matrix4> from(2), to(2);
  from[1].m[14] = -99;
  to[1].m[14] = -102;
  body.move(from, to);
  const MovingTriangles triangles = body.triangles();
  std::size_t ambiguous = 0;
  for (const MovingContact& found : body.contacts()) {
    const auto [s, t] = found.contact;
    EXPECT_EQ(found, contact_of(s, t, *first_meeting_of(triangles[s], triangles[t])));
    const MovingContact swapped = contact_of(t, s, *first_meeting_of(triangles[t], triangles[s]));
    ambiguous += found.a != swapped.b || found.b != swapped.a;
  }
  EXPECT_GT(ambiguous, 20u);
}

TEST(SelfCollideMoving, ContainsTheContactsOfBothEnds) {
  Random random(1844);
  FoldingLimb limb;
  std::size_t at_ends = 0;
  for (int round = 0; round < 20; ++round) {
    limb.fold(random);
    const auto all = limb.contacts();
    const auto found = pairs_of(all);
    for (Pose* end : {&limb.from, &limb.to}) {
      const auto contacts = self_contacts_of(*end, limb.filter, limb.scratch);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), contacts.begin(), contacts.end()));
      at_ends += contacts.size();
    }
    const auto at_start = self_contacts_of(limb.from, limb.filter, limb.scratch);
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& c) { return c.at_start; }),
              static_cast<std::ptrdiff_t>(at_start.size()));
  }
  EXPECT_GT(at_ends, 200u);
}

TEST(SelfCollideMoving, HasOptionsForTimesAndForContactsAtTheStart) {
  Random random(1845);
  FoldingLimb limb;
  limb.fold(random);
  const auto all = limb.contacts();
  ASSERT_GT(all.size(), 20u);
  EXPECT_EQ(pairs_of(limb.contacts({.times = false})), pairs_of(all));
  std::vector<MovingContact> later;
  std::copy_if(all.begin(), all.end(), std::back_inserter(later),
               [](const MovingContact& c) { return !c.at_start; });
  EXPECT_EQ(limb.contacts({.leave_out_start = true}), later);
  EXPECT_EQ(limb.contacts({.max_contacts = 3}).size(), 3u);
  EXPECT_TRUE(self_intersects(limb.step(), limb.filter, limb.scratch).answer);
}

TEST(SelfCollideMoving, ObeysTheFilter) {
  Random random(1846);
  FoldingLimb all, filtered({.rings = 3});
  std::size_t kept = 0, left_out = 0;
  for (int round = 0; round < 6; ++round) {
    Random same = random;
    all.fold(random);
    filtered.fold(same);
    std::vector<MovingContact> expected = all.contacts(), found;
    const std::size_t before = expected.size();
    std::erase_if(expected, [&](const MovingContact& c) {
      return filtered.filter.left_out_by(c.contact.triangle_a, c.contact.triangle_b) !=
             LeftOutBy::none;
    });
    const SelfMovingStats stats =
        self_collide(filtered.step(), filtered.filter, filtered.scratch, found);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(stats.left_out.rings, before - expected.size());
    kept += found.size();
    left_out += stats.left_out.total();
  }
  EXPECT_GT(kept, 20u);
  EXPECT_GT(left_out, 20u);
}

TEST(SelfCollideMoving, TestsFewPairsExactly) {
  Random random(1847);
  FoldingLimb limb;
  SelfMovingStats work;
  std::size_t contacts = 0;
  for (int round = 0; round < 20; ++round) {
    limb.fold(random);
    std::vector<MovingContact> found;
    work += self_collide(limb.step(), limb.filter, limb.scratch, found);
    contacts += found.size();
  }
  std::printf("seed 1847: %llu pairs, %llu in double, %llu exactly, %zu contacts\n",
              static_cast<unsigned long long>(work.triangle_pairs),
              static_cast<unsigned long long>(work.double_pairs),
              static_cast<unsigned long long>(work.exact_pairs), contacts);
  EXPECT_LT(work.exact_pairs, contacts / 2);
}

TEST(SelfCollideMovingDeathTest, AFilterOfAnotherModelAborts) {
  FoldingLimb limb, other;
  std::vector<MovingContact> found;
  EXPECT_DEATH(self_collide(limb.step(), other.filter, limb.scratch, found),
               "self_collide: the filter is of another model");
}

}  // namespace
}  // namespace pelt::test
