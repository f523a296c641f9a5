/// Every method that starts from posed vertices finds the contacts of brute force, on bodies that
/// are hard for trees and grids.

#include <pelt/model.hpp>
#include <pelt/pose.hpp>

#include "evaluation/rivals/posed_bodies.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"
#include "scenes/creature.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pelt::rivals {
namespace {

using test::all_contacts;
using test::Contacts;
using test::PosedBodies;
using test::PosedBody;
using test::Random;

struct NamedMethod {
  const char* name;
  std::unique_ptr<PosedMeshMethod> (*make)();
};

class Methods : public testing::TestWithParam<NamedMethod> {
 protected:
  /// The method with both bodies added, before any update.
  static std::unique_ptr<PosedMeshMethod> method_with(const PosedBodies& bodies) {
    auto method = GetParam().make();
    method->add(bodies.a.triangles, bodies.a.frames[0]);
    method->add(bodies.b.triangles, bodies.b.frames[0]);
    return method;
  }

  static void pose(PosedMeshMethod& method, const PosedBodies& bodies, std::size_t frame) {
    method.update(0, bodies.a.frames[frame]);
    method.update(1, bodies.b.frames[frame]);
  }

  static Contacts ask(PosedMeshMethod& method, std::uint32_t a, std::uint32_t b) {
    Contacts contacts;
    const QueryStats work = method.collide(a, b, contacts, ~0u);
    EXPECT_FALSE(work.cut_short);
    EXPECT_LE(contacts.size(), work.triangle_pairs);
    std::sort(contacts.begin(), contacts.end());
    return contacts;
  }

  /// Queries each frame in both orders. Returns the number of contacts of all frames.
  static std::size_t check_frames(const PosedBodies& bodies) {
    const auto method = method_with(bodies);
    std::size_t total = 0;
    for (std::size_t frame = 0; frame < bodies.a.frames.size(); ++frame) {
      pose(*method, bodies, frame);
      const Contacts expected = all_contacts(bodies, frame);
      EXPECT_EQ(ask(*method, 0, 1), expected) << "frame " << frame;
      Contacts swapped = ask(*method, 1, 0);
      for (Contact& contact : swapped) std::swap(contact.triangle_a, contact.triangle_b);
      std::sort(swapped.begin(), swapped.end());
      EXPECT_EQ(swapped, expected) << "frame " << frame;
      total += expected.size();
    }
    return total;
  }
};

PosedBodies pair_of(const std::function<PosedBody()>& make) {
  PosedBody a = make();
  return {std::move(a), make()};
}

Vec3 in_unit_cube(Random& random) { return random.point(1); }

/// Pairs of bodies that are hard for trees or grids.
struct HardBodies {
  const char* name;
  int rounds;
  std::size_t least_contacts;  ///< in all rounds
  std::function<PosedBodies(Random& random, int round)> make;
};

const HardBodies kHardBodies[] = {
    {"soups of any size", 30, 1000,
     [](Random& random, int) {
       const double spread = random.uniform(0.5, 3), size = random.uniform(0.1, 1);
       return pair_of([&] {
         return test::scattered(
             random, 1 + random.index(120), 3, [&](Random& r) { return r.point(spread); },
             [&](Random&) { return size; });
       });
     }},
    {"touching and coplanar triangles on a grid", 20, 5000,
     [](Random& random, int round) {
       return pair_of([&] {
         PosedBody body = test::scattered(
             random, 100, 3, [](Random& r) { return r.point(4); }, [](Random&) { return 1.5; });
         for (auto& frame : body.frames)
           for (Vec3& p : frame)
             p = {std::round(p.x), std::round(p.y), round % 2 ? 0 : std::round(p.z)};
         return body;
       });
     }},
    {"collapsed triangles", 20, 20 * 60 * 60,
     [](Random& random, int) {
       return pair_of([&] {
         PosedBody body = test::scattered(random, 60, 3, in_unit_cube, [](Random&) { return 1.0; });
         for (std::size_t t = 0; t < 60; ++t) body.triangles[t][2] = body.triangles[t][t % 2];
         for (Vec3& p : body.frames[1]) p = {1, 2, 3};           // all in one point
         for (Vec3& p : body.frames[2]) p = {p.x, 2 * p.x, -1};  // all on one line
         return body;
       });
     }},
    {"far from the origin", 3, 1000,
     [](Random& random, int round) {
       const float distance = std::array{1e5f, -1e7f, 0x1p59f}[static_cast<std::size_t>(round)];
       return pair_of([&] {
         PosedBody body = test::scattered(random, 80, 3, in_unit_cube, [](Random&) { return 0.7; });
         for (auto& frame : body.frames)
           for (Vec3& p : frame) p = {p.x + distance, p.y - distance, p.z + 0.5f * distance};
         return body;
       });
     }},
    {"huge triangles among tiny ones", 6, 300, [](Random& random, int round) {
       return pair_of([&] {
         return test::scattered(random, 400, 2, in_unit_cube, [&](Random& r) {
           return r.chance(0.03) ? (round % 2 ? 1e6 : 30.0) : 0.003;
         });
       });
     }}};

TEST_P(Methods, FindTheContactsOfHardBodies) {
  std::uint64_t seed = 0;
  for (const HardBodies& hard : kHardBodies) {
    SCOPED_TRACE(hard.name);
    Random random(++seed);
    std::size_t contacts = 0;
    for (int round = 0; round < hard.rounds; ++round)
      contacts += check_frames(hard.make(random, round));
    EXPECT_GT(contacts, hard.least_contacts);
  }
}

TEST_P(Methods, FindNothingBetweenSeparatedBodies) {
  Random random(6);
  PosedBodies bodies = pair_of([&] {
    return test::scattered(
        random, 50, 2, [](Random& r) { return r.point(1); }, [](Random&) { return 0.5; });
  });
  for (auto& frame : bodies.b.frames)
    for (Vec3& p : frame) p.y += 10;
  const auto method = method_with(bodies);
  pose(*method, bodies, 1);
  Contacts contacts;
  const QueryStats work = method->collide(0, 1, contacts, ~0u);
  EXPECT_TRUE(contacts.empty());
  EXPECT_EQ(work.triangle_pairs, 0u);
}

TEST_P(Methods, KeepLimits) {
  Random random(7);
  const PosedBodies bodies = pair_of([&] {
    return test::scattered(
        random, 80, 1, [](Random& r) { return r.point(1); }, [](Random&) { return 0.6; });
  });
  const auto method = method_with(bodies);
  pose(*method, bodies, 0);
  const Contacts all = all_contacts(bodies, 0);
  const auto total = static_cast<std::uint32_t>(all.size());
  ASSERT_GT(total, 100u);
  for (const std::uint32_t limit : {0u, 1u, 7u, 8u, 9u, total - 1, total, total + 1}) {
    Contacts contacts = {{5, 6}};
    const QueryStats work = method->collide(0, 1, contacts, limit);
    ASSERT_EQ(contacts[0], (Contact{5, 6}));  // appended
    contacts.erase(contacts.begin());
    EXPECT_EQ(contacts.size(), std::min(limit, total));
    std::sort(contacts.begin(), contacts.end());
    EXPECT_TRUE(std::includes(all.begin(), all.end(), contacts.begin(), contacts.end()));
    EXPECT_EQ(std::adjacent_find(contacts.begin(), contacts.end()), contacts.end());
    if (limit != total) {
      EXPECT_EQ(work.cut_short, limit < total) << limit;
    }
  }
}

TEST_P(Methods, FindOneContactWhereThereIsOne) {
  Random random(9);
  int touching = 0;
  for (int i = 0; i < 40; ++i) {
    const PosedBodies bodies = pair_of([&] {
      return test::scattered(
          random, 1 + random.index(60), 1, [](Random& r) { return r.point(2); },
          [](Random&) { return 0.8; });
    });
    const auto method = method_with(bodies);
    pose(*method, bodies, 0);
    const Contacts all = all_contacts(bodies, 0);
    Contacts found;
    method->collide(0, 1, found, 1);
    ASSERT_EQ(found.empty(), all.empty());
    EXPECT_TRUE(found.empty() || std::find(all.begin(), all.end(), found[0]) != all.end());
    touching += !all.empty();
  }
  std::printf("%d of 40 touch\n", touching);
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 40);
}

/// Two walking creatures that approach each other.
PosedBodies walkers(std::uint32_t frames) {
  const auto asset = scenes::make_creature({1000, 24, 1});
  EXPECT_TRUE(asset) << asset.error().message;
  const auto model = build_model(asset->mesh());
  EXPECT_TRUE(model);
  const asset::Clip* walk = asset->find_clip("walk");
  Pose pose(*model);
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(model->joint_count());
  const auto walker = [&](double phase, double from, double to) {
    PosedBody body;
    body.triangles.assign(asset->mesh().triangles.begin(), asset->mesh().triangles.end());
    for (std::uint32_t f = 0; f < frames; ++f) {
      const double along = f / (frames - 1.0);
      Matrix4 world;
      world.m[12] = static_cast<float>(from + along * (to - from));
      sample_palette(*asset, walk, static_cast<float>(phase + along), world, scratch, palette);
      EXPECT_TRUE(pose.set_palette(palette));
      body.frames.emplace_back(model->vertex_count());
      posed_vertices(pose, body.frames.back());
    }
    return body;
  };
  return {walker(0, -0.6, 0), walker(0.4, 0.6, 0.1)};
}

TEST_P(Methods, FindTheContactsOfWalkers) {
  const PosedBodies bodies = walkers(6);
  const std::size_t contacts = check_frames(bodies);
  std::printf("%zu contacts\n", contacts);
  EXPECT_TRUE(all_contacts(bodies, 0).empty());
  EXPECT_GT(contacts, 500u);
}

TEST_P(Methods, DistinguishBodiesOfOneMesh) {
  Random random(8);
  PosedBodies bodies = pair_of([&] {
    return test::scattered(
        random, 60, 4, [](Random& r) { return r.point(1); }, [](Random&) { return 0.5; });
  });
  const auto method = GetParam().make();
  for (int i = 0; i < 3; ++i) method->add(bodies.a.triangles, bodies.a.frames[0]);
  for (std::uint32_t i = 0; i < 3; ++i) method->update(i, bodies.a.frames[i]);
  method->update(1, bodies.a.frames[3]);  // updates one body only
  for (const auto& [first, second] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 2u)}) {
    const auto frame_of = [&](std::uint32_t i) { return bodies.a.frames[i == 1 ? 3 : i]; };
    const PosedBodies asked = {{bodies.a.triangles, {frame_of(first)}},
                               {bodies.a.triangles, {frame_of(second)}}};
    EXPECT_EQ(ask(*method, first, second), all_contacts(asked, 0));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rivals, Methods,
    testing::Values(NamedMethod{"aabb_refit", [] { return make_aabb_refit(); }},
                    NamedMethod{"aabb_refit_small_leaves", [] { return make_aabb_refit({1}); }},
                    NamedMethod{"aabb_rebuild", [] { return make_aabb_rebuild(); }},
                    NamedMethod{"hybrid", [] { return make_hybrid(); }},
                    NamedMethod{"hybrid_small_leaves", [] { return make_hybrid({2}); }},
                    NamedMethod{"hash_crowd", [] { return make_hash_crowd(); }},
                    NamedMethod{"hash", [] { return make_hash(); }},
                    NamedMethod{"hash_small_cells",
                                [] { return make_hash({.cell_edges = 0.25f}); }},
                    NamedMethod{"hash_overlap", [] { return make_hash_overlap(); }},
                    NamedMethod{"hash_overlap_large_cells",
                                [] { return make_hash_overlap({.cell_edges = 8}); }}),
    [](const auto& named) { return std::string(named.param.name); });

TEST(Hybrid, RefitsLowerBoxesWhereTheQueryGoesAndOncePerUpdate) {
  test::Random random(1);
  const auto make = [&] {
    return test::scattered(
        random, 500, 2, [](test::Random& r) { return r.point(1); },
        [](test::Random&) { return 0.2; });
  };
  const test::PosedBody a = make(), b = make();
  test::Positions aside = b.frames[1];
  for (Vec3& p : aside) p.x += 2;
  const auto method = make_hybrid();
  method->add(a.triangles, a.frames[0]);
  method->add(b.triangles, b.frames[0]);
  std::vector<Contact> contacts;
  const auto refits_after = [&](const test::Positions& positions_b) {
    method->update(0, a.frames[1]);
    method->update(1, positions_b);
    return method->collide(0, 1, contacts, ~0u).refits;
  };

  test::Positions far = b.frames[1];
  for (Vec3& p : far) p.x += 10;
  EXPECT_EQ(refits_after(far), 0u);
  const std::uint64_t some = refits_after(aside), many = refits_after(b.frames[1]);
  EXPECT_GT(some, 0u);
  EXPECT_LT(some, many);
  EXPECT_EQ(method->collide(0, 1, contacts, ~0u).refits, 0u);
  EXPECT_EQ(method->collide(1, 0, contacts, ~0u).refits, 0u);
  method->update(0, a.frames[1]);
  const std::uint64_t one_stale = method->collide(0, 1, contacts, ~0u).refits;
  EXPECT_GT(one_stale, 0u);
  EXPECT_LT(one_stale, many);
}

}  // namespace

}  // namespace pelt::rivals
