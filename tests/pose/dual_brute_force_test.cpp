/// Queries of poses with dual quaternion skinning against brute force over all pairs of triangles.

#include "collide/contacts_of.hpp"
#include "pose/dual_bodies.hpp"
#include "ray/ray_cases.hpp"
#include "ray/ray_oracle.hpp"
#include "self/self_brute_force.hpp"
#include "self/self_moving_brute_force.hpp"
#include "support/instruction_sets.hpp"

#include <pelt/pelt.hpp>
#include <pelt/search.hpp>

namespace pelt::test {
namespace {

std::vector<detail::MovingTriangle> moving_triangles(const DualBody& body) {
  std::vector<Vec3> first(body.shape.rest_positions.size()), last(first.size());
  posed_vertices(body.from, first);
  posed_vertices(body.to, last);
  std::vector<detail::MovingTriangle> all;
  for (const auto& [p, q, r] : body.shape.triangles)
    all.push_back({{first[p], first[q], first[r]}, {last[p], last[q], last[r]}});
  return all;
}

TEST(DualBruteForce, CollideFindsAllPairs) {
  Random random(150);
  std::size_t contacts = 0;
  int touching = 0, apart = 0;
  on_all_kinds(random, 6, 100, 0.15, [&](DualBody& a, DualBody& b) {
    const std::vector<Contact> expected = brute_force(a.shape, a.to, b.shape, b.to);
    on_each_instruction_set([&](InstructionSet) {
      Scratch scratch;
      a.to.reserve(), b.to.reserve();  // closes all nodes
      ASSERT_EQ(contacts_of(a.to, b.to, scratch), expected);
    });
    contacts += expected.size();
    ++(expected.empty() ? apart : touching);
  });
  std::printf("%zu contacts, %d touching, %d apart\n", contacts, touching, apart);
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(touching, 100);
  EXPECT_GT(apart, 5);
}

/// The surface vertices of a model with offsets and morph targets are those of the shape.
TEST(DualBruteForce, SelfCollisionFindsAllPairs) {
  Random random(151);
  std::size_t contacts = 0;
  on_all_kinds(random, 4, 100, 0.15, [&](DualBody& body, DualBody&) {
    const std::vector<Contact> expected = brute_force_self(body.shape, body.to);
    const SelfFilter filter = *build_self_filter(body.to.model());
    SelfTracker tracker(filter);
    Scratch scratch;
    ASSERT_EQ(self_contacts_of(body.to, filter, scratch), expected);
    for (Pose* pose : {&body.from, &body.to, &body.to}) {
      std::vector<Contact> found;
      self_collide(*pose, tracker, scratch, found);
      ASSERT_EQ(found, pose == &body.to ? expected : brute_force_self(body.shape, body.from));
    }
    contacts += expected.size();
  });
  std::printf("%zu contacts\n", contacts);
  EXPECT_GT(contacts, 10000u);
}

TEST(DualBruteForce, TrackersFollowSlowMotions) {
  Random random(152);
  int changes = 0, frames = 0;
  std::size_t contacts = 0;
  for (const DualKind& kind : dual_kinds(Turns::small)) {
    DualBody body(random, kind, 100);
    const SelfFilter filter = *build_self_filter(body.to.model());
    SelfTracker tracker(filter);
    Scratch scratch;
    std::vector<Contact> last;
    body.move(random, 0.1);
    const Random axis = random;
    for (int frame = 0; frame < 40; ++frame, ++frames) {
      Random same = axis;
      ASSERT_TRUE(body.to.set_palette(bend_limb(same, kDualJoints, 0.02 * frame, {})));
      std::vector<Contact> found;
      self_collide(body.to, tracker, scratch, found);
      ASSERT_EQ(found, brute_force_self(body.shape, body.to)) << "frame " << frame;
      contacts += found.size();
      changes += found != last;
      last = found;
    }
  }
  std::printf("%zu contacts, %d changes in %d frames\n", contacts, changes, frames);
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(changes, frames / 2);
}

/// The first of all contacts: those at the start come first.
std::optional<MovingContact> first_of(const std::vector<MovingContact>& contacts) {
  const auto first = std::min_element(
      contacts.begin(), contacts.end(), [](const MovingContact& x, const MovingContact& y) {
        return std::pair(!x.at_start, x.time) < std::pair(!y.at_start, y.time);
      });
  return first == contacts.end() ? std::nullopt : std::optional(*first);
}

void expect_first(DualBody& a, DualBody& b, const std::vector<MovingContact>& all) {
  Scratch scratch;
  const std::optional<MovingContact> expected = first_of(all);
  std::optional<MovingContact> found;
  first_contact(a.step(), b.step(), scratch, found);
  ASSERT_EQ(found.has_value(), expected.has_value());
  FirstContactSearch search(a.step(), b.step());
  while (!search.is_complete()) search.advance(1000);
  if (!expected) return;
  // Contacts at equal times in float may differ in their exact times.
  EXPECT_EQ(std::pair(found->at_start, found->time), std::pair(expected->at_start, expected->time));
  ASSERT_NE(std::find(all.begin(), all.end(), *found), all.end());
  ASSERT_TRUE(search.earliest());
  EXPECT_EQ(*search.earliest(), *found);
}

TEST(DualBruteForce, MotionsFindAllPairsAndTheFirstOne) {
  Random random(153);
  std::size_t contacts = 0, later = 0;
  int apart = 0;
  on_all_kinds(random, 2, 48, 0.15, [&](DualBody& a, DualBody& b) {
    const std::vector<detail::MovingTriangle> s = moving_triangles(a), t = moving_triangles(b);
    const std::vector<MovingContact> expected = brute_force_moving(s, t);
    on_each_instruction_set([&](InstructionSet) {
      Scratch scratch;
      for (Pose* pose : {&a.from, &a.to, &b.from, &b.to}) pose->reserve();  // closes all nodes
      std::vector<MovingContact> found;
      collide(a.step(), b.step(), scratch, found);
      ASSERT_EQ(found, expected);
    });
    expect_first(a, b, expected);
    contacts += expected.size();
    apart += expected.empty();
    for (const MovingContact& contact : expected) later += !contact.at_start;
  });
  std::printf("%zu contacts, %zu not at the start, %d steps without\n", contacts, later, apart);
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(later, 5000u);
  EXPECT_GT(apart, 1);
}

TEST(DualBruteForce, MotionsFindAllPairsOfABodyWithItself) {
  Random random(154);
  std::size_t contacts = 0, later = 0;
  on_all_kinds(random, 1, 40, 0.15, [&](DualBody& body, DualBody&) {
    const auto corners = surface_corners(body.shape.triangles, surface_vertices(body.shape));
    const auto expected = brute_force_self_moving(moving_triangles(body), corners, true);
    const SelfFilter filter = *build_self_filter(body.to.model());
    Scratch scratch;
    std::vector<MovingContact> found;
    self_collide(body.step(), filter, scratch, found);
    ASSERT_EQ(found, expected);
    contacts += expected.size();
    for (const MovingContact& contact : expected) later += !contact.at_start;
  });
  std::printf("%zu contacts, %zu not at the start\n", contacts, later);
  EXPECT_GT(contacts, 3000u);
  EXPECT_GT(later, 1000u);
}

TEST(DualBruteForce, RaysHitAllTriangles) {
  Random random(155);
  std::size_t hits = 0, misses = 0;
  on_all_kinds(random, 3, 100, 0.15, [&](DualBody& body, DualBody&) {
    Scratch scratch;
    const RayOracle oracle(body.shape.triangles, body.to);
    const RayCases cases(body.shape.triangles, oracle.positions());
    for (int i = 0; i < 60; ++i) {
      const std::size_t count = expect_as_oracle(body.to, oracle, cases.next(random), scratch);
      hits += count;
      misses += count == 0;
    }
  });
  std::printf("%zu hits, %zu rays without\n", hits, misses);
  EXPECT_GT(hits, 5000u);
  EXPECT_GT(misses, 500u);
}

}  // namespace
}  // namespace pelt::test
