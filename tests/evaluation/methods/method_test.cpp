/// All methods find the same contacts, and do the work that their names promise.

#include "evaluation/methods/lab_methods.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "paper/on_demand.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pelt::methods {
namespace {

using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

using Contacts = std::vector<Contact>;
using Joints = std::vector<Matrix4>;

constexpr std::uint32_t kJoints = 5;
constexpr auto& kKinds = lab::kLabMethods;

SkinnedModel model_of(const Shape& shape) {
  auto model = build_model(shape.view());
  EXPECT_TRUE(model) << model.error().message;
  return *model;
}

std::uint64_t node_count(const SkinnedModel& model) {
  return paper::build_sphere_model(detail::unpack_mesh(model.detail().tree)).tree.nodes.size();
}

/// Two posed bodies, and the answer of a method.
struct Scene {
  SkinnedModel models[2];
  Joints palettes[2];
};

/// A method with the two bodies of a scene.
std::unique_ptr<Method> method_with(const MethodKind& kind, const Scene& scene) {
  std::unique_ptr<Method> method = kind.make();
  for (std::uint32_t body = 0; body < 2; ++body) {
    method->add(scene.models[body]);
    EXPECT_TRUE(method->set_palette(body, scene.palettes[body]));
  }
  return method;
}

Contacts contacts_of(const MethodKind& kind, const Scene& scene) {
  Contacts contacts;
  method_with(kind, scene)->collide(0, 1, contacts, {});
  return contacts;
}

/// Bending limbs, and soups with moving triangles: some touch, some do not.
Scene random_scene(Random& random, int i) {
  if (i % 3 == 0)
    return {{model_of(test::make_limb(12, 8, kJoints)), model_of(test::make_limb(9, 7, kJoints))},
            {bend_limb(random, kJoints, 0.3, random.point(0.6)),
             bend_limb(random, kJoints, 0.5, random.point(0.6))}};
  const Weights weights = i % 2 == 0 ? Weights::random : Weights::adversarial;
  const Motion motion = static_cast<Motion>(random.index(4));
  const auto soup = [&] { return model_of(make_soup(random, 60, kJoints, 4, weights)); };
  const double spread = random.uniform(0, 3);
  SkinnedModel a = soup(), b = soup();
  Joints palette_a = make_palette(random, kJoints, motion, spread);
  Joints palette_b = make_palette(random, kJoints, motion, spread);
  return {{std::move(a), std::move(b)}, {std::move(palette_a), std::move(palette_b)}};
}

/// Limbs side by side: nothing overlaps, not even the root spheres.
Scene separated_scene(Random& random) {
  const SkinnedModel limb = model_of(test::make_limb(12, 8, kJoints));
  return {
      {limb, limb},
      {bend_limb(random, kJoints, 0.2, {-10, 0, 0}), bend_limb(random, kJoints, 0.2, {10, 0, 0})}};
}

/// Crossing limbs.
Scene crossing_scene(Random& random) {
  const SkinnedModel limb = model_of(test::make_limb(12, 8, kJoints));
  Joints across = bend_limb(random, kJoints, 0.1, {});
  const Matrix4 turned = test::rotation_about({0, 0, 1}, 1.5, {0, 0.5f, 0}, {});
  std::fill(across.begin(), across.end(), turned);
  return {{limb, limb}, {bend_limb(random, kJoints, 0.1, {}), across}};
}

TEST(Methods, AllFindTheContactsOfBruteForce) {
  Random random(1);
  constexpr int kScenes = 150;
  int touching = 0;
  for (int i = 0; i < kScenes; ++i) {
    const Scene scene = random_scene(random, i);
    const Contacts expected = contacts_of(kBrute, scene);
    ASSERT_TRUE(std::is_sorted(expected.begin(), expected.end()));
    for (const MethodKind& kind : kKinds)
      ASSERT_EQ(contacts_of(kind, scene), expected) << kind.name << ", scene " << i;
    touching += !expected.empty();
  }
  std::printf("%d of %d scenes touch\n", touching, kScenes);
  EXPECT_GT(touching, kScenes / 3);
  EXPECT_LT(touching, kScenes * 95 / 100);
}

TEST(Methods, SwappedBodiesGiveSwappedPairs) {
  Random random(2);
  int touching = 0;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = random_scene(random, i);
    for (const MethodKind& kind : kKinds) {
      const auto method = method_with(kind, scene);
      Contacts forward, backward;
      method->collide(0, 1, forward, {});
      method->collide(1, 0, backward, {});
      for (Contact& contact : backward) std::swap(contact.triangle_a, contact.triangle_b);
      std::sort(backward.begin(), backward.end());
      ASSERT_EQ(backward, forward) << kind.name;
      touching += !forward.empty();
    }
  }
  EXPECT_GT(touching, 60);
}

TEST(Methods, SkinWhenTheySayTheyDo) {
  Random random(8);
  const Scene scene = separated_scene(random);
  const std::uint64_t vertices = scene.models[0].vertex_count() + scene.models[1].vertex_count();
  for (const MethodKind& kind : kKinds) {
    const auto method = method_with(kind, scene);
    if (!method->update_counts()) continue;
    const std::uint64_t before = method->update_work().posed_vertices;
    for (std::uint32_t body = 0; body < 2; ++body)
      ASSERT_TRUE(method->set_palette(body, scene.palettes[body]));
    const std::uint64_t skinned = method->update_work().posed_vertices - before;
    if (kind.skins == Skins::where_queried) {
      EXPECT_EQ(skinned, 0u) << kind.name;
    } else {
      EXPECT_GE(skinned, vertices) << kind.name;
    }
  }
}

TEST(Methods, AnswerAgainAfterANewPalette) {
  Random random(3);
  const Scene scene = crossing_scene(random);
  for (const MethodKind& kind : kKinds) {
    const auto method = method_with(kind, scene);
    Contacts contacts, apart, again;
    method->collide(0, 1, contacts, {});
    ASSERT_TRUE(method->set_palette(1, separated_scene(random).palettes[1]));
    method->collide(0, 1, apart, {});
    ASSERT_TRUE(method->set_palette(1, scene.palettes[1]));
    method->collide(0, 1, again, {});
    EXPECT_FALSE(contacts.empty());
    EXPECT_TRUE(apart.empty());
    EXPECT_EQ(again, contacts);
  }
}

TEST(Methods, LimitsAreRespectedAndReported) {
  Random random(4);
  int limited = 0;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = random_scene(random, i);
    const Contacts all = contacts_of(kBrute, scene);
    const auto total = static_cast<std::uint32_t>(all.size());
    for (const std::uint32_t limit : {0u, 1u, 2u, total / 2, total, total + 1})
      for (const MethodKind& kind : kKinds) {
        Contacts contacts = {{7, 7}};
        const auto method = method_with(kind, scene);
        const QueryStats stats = method->collide(0, 1, contacts, {.max_contacts = limit});
        ASSERT_EQ(contacts[0], (Contact{7, 7}));  // the query appends
        contacts.erase(contacts.begin());
        ASSERT_EQ(contacts.size(), std::min(limit, total)) << kind.name;
        ASSERT_TRUE(std::includes(all.begin(), all.end(), contacts.begin(), contacts.end()));
        if (limit < total) {
          ASSERT_TRUE(stats.cut_short) << kind.name;
        } else if (limit > total) {
          ASSERT_FALSE(stats.cut_short) << kind.name;
        }
        limited += limit < total;
      }
  }
  EXPECT_GT(limited, 200);
}

TEST(Methods, StopAtTheFirstContactWithLessWork) {
  Random random(5);
  const Scene scene = crossing_scene(random);
  for (const MethodKind& kind : kKinds) {
    const auto all = method_with(kind, scene), first = method_with(kind, scene);
    Contacts contacts;
    const QueryStats all_work = all->collide(0, 1, contacts, {});
    const QueryStats first_work = first->collide(0, 1, contacts, {.max_contacts = 1});
    EXPECT_LT(first_work.triangle_pairs, all_work.triangle_pairs) << kind.name;
    EXPECT_LE(first_work.refits, all_work.refits) << kind.name;
  }
}

class OnDemand : public testing::TestWithParam<MethodKind> {};

TEST_P(OnDemand, RefitsOnlyTheRootsOfSeparatedBodies) {
  Random random(6);
  const auto method = method_with(GetParam(), separated_scene(random));
  Contacts contacts;
  const QueryStats stats = method->collide(0, 1, contacts, {});
  EXPECT_EQ(stats.node_pairs, 1u);
  EXPECT_EQ(stats.refits, 2u);
  EXPECT_EQ(stats.posed_vertices, 0u);
  EXPECT_EQ(stats.triangle_pairs, 0u);
  EXPECT_EQ(method->update_work().refits + method->update_work().posed_vertices, 0u);
}

TEST_P(OnDemand, RefitsAndSkinsAtMostOnceForEachPalette) {
  Random random(7);
  const Scene scene = crossing_scene(random);
  const auto method = method_with(GetParam(), scene);
  Contacts contacts;
  const QueryStats once = method->collide(0, 1, contacts, {});
  EXPECT_FALSE(contacts.empty());
  EXPECT_GT(once.refits, 2u);
  EXPECT_LT(once.refits, 2 * node_count(scene.models[0]));
  EXPECT_LT(once.posed_vertices, 2 * scene.models[0].vertex_count());

  const QueryStats again = method->collide(0, 1, contacts, {});
  const QueryStats swapped = method->collide(1, 0, contacts, {});
  EXPECT_EQ(again.node_pairs, once.node_pairs);
  EXPECT_EQ(again.refits + again.posed_vertices, 0u);
  EXPECT_EQ(swapped.posed_vertices, 0u);
  EXPECT_LE(once.refits + swapped.refits, 2 * node_count(scene.models[0]));

  ASSERT_TRUE(method->set_palette(0, scene.palettes[0]));
  const QueryStats one_stale = method->collide(0, 1, contacts, {});
  EXPECT_GT(one_stale.refits, 0u);
  EXPECT_LT(one_stale.refits, once.refits);  // the other body's spheres are still valid
}

INSTANTIATE_TEST_SUITE_P(Bound, OnDemand, testing::Values(kPaper, lab::kPaperEq2, lab::kBdTree),
                         [](const auto& kind) { return std::string(kind.param.name); });

/// The work of setting two palettes, without adding the bodies.
QueryStats work_of_palettes(Method& method, const Scene& scene) {
  const QueryStats before = method.update_work();
  for (std::uint32_t body = 0; body < 2; ++body)
    EXPECT_TRUE(method.set_palette(body, scene.palettes[body]));
  QueryStats work = method.update_work();
  work.refits -= before.refits;
  work.posed_vertices -= before.posed_vertices;
  return work;
}

struct EagerWork {
  MethodKind kind;
  bool refits_all;
};

TEST(Methods, RivalsPoseEveryVertexAndOnlyTheEagerOneRefits) {
  Random random(8);
  for (const Scene& scene : {separated_scene(random), crossing_scene(random)})
    for (const auto& [kind, refits_all] :
         {EagerWork{lab::kPaperEager, true}, EagerWork{lab::kPaperRigid, false},
          EagerWork{kBrute, false}}) {
      const auto method = method_with(kind, scene);
      const QueryStats update = work_of_palettes(*method, scene);
      const SkinnedModel &a = scene.models[0], &b = scene.models[1];
      EXPECT_EQ(update.posed_vertices, a.vertex_count() + b.vertex_count()) << kind.name;
      EXPECT_EQ(update.refits, refits_all ? node_count(a) + node_count(b) : 0) << kind.name;
      Contacts contacts;
      const QueryStats query = method->collide(0, 1, contacts, {});
      EXPECT_EQ(query.posed_vertices + query.refits, 0u) << kind.name;
      EXPECT_EQ(query.node_pairs == 0, kind == kBrute) << kind.name;
    }
}

std::uint64_t slot_count(const SkinnedModel& model) {
  const detail::Tree& tree = model.detail().tree;
  return tree.clusters.size() + tree.nodes.size() - 1;
}

TEST(Methods, EagerOpensAllInItsUpdate) {
  Random random(11);
  for (const Scene& scene : {separated_scene(random), crossing_scene(random)}) {
    const auto method = method_with(kEager, scene);
    const QueryStats update = work_of_palettes(*method, scene);
    const SkinnedModel &a = scene.models[0], &b = scene.models[1];
    EXPECT_EQ(update.refits, slot_count(a) + slot_count(b));
    EXPECT_GE(update.posed_vertices, a.vertex_count() + b.vertex_count());
    Contacts contacts;
    const QueryStats query = method->collide(0, 1, contacts, {});
    EXPECT_EQ(query.posed_vertices + query.refits, 0u);
    EXPECT_GT(query.node_pairs, 0u);
  }
}

TEST(Methods, RigidBodiesDoNoWorkButQueries) {
  Random random(12);
  const Scene scene = crossing_scene(random);
  const auto method = method_with(lab::kRigid, scene);
  Contacts contacts;
  const QueryStats query = method->collide(0, 1, contacts, {});
  EXPECT_FALSE(contacts.empty());
  EXPECT_EQ(query.posed_vertices + query.refits, 0u);
  EXPECT_EQ(method->update_work().posed_vertices, 0u);
}

TEST(Methods, UpdatesCountUnlessBodiesAreRigid) {
  for (const MethodKind& kind : kKinds) {
    const bool is_rigid = kind == lab::kRigid || kind == lab::kPaperRigid;
    EXPECT_EQ(kind.make()->update_counts(), !is_rigid) << kind.name;
  }
}

TEST(Methods, TighterSpheresTestFewerPairs) {
  Random random(9);
  std::uint64_t optimised = 0, plain = 0;
  for (int i = 0; i < 20; ++i) {
    const Scene scene = crossing_scene(random);
    Contacts contacts;
    optimised += method_with(kPaper, scene)->collide(0, 1, contacts, {}).node_pairs;
    plain += method_with(lab::kPaperEq2, scene)->collide(0, 1, contacts, {}).node_pairs;
  }
  std::printf("%llu sphere pairs, by eq. 2 %llu\n", static_cast<unsigned long long>(optimised),
              static_cast<unsigned long long>(plain));
  EXPECT_LT(optimised, plain);
}

TEST(Methods, RefuseABadPaletteAndKeepTheOldOne) {
  Random random(10);
  const Scene scene = crossing_scene(random);
  Joints bad = scene.palettes[0];
  bad[1].m[5] = std::numeric_limits<float>::quiet_NaN();
  for (const MethodKind& kind : kKinds) {
    const auto method = method_with(kind, scene);
    EXPECT_FALSE(method->set_palette(0, bad));
    Contacts contacts;
    method->collide(0, 1, contacts, {});
    EXPECT_EQ(contacts, contacts_of(kBrute, scene)) << kind.name;
  }
}

/// Methods that bound vertices by how joints move rest positions cannot bound displaced vertices.
bool knows_morph_targets(const MethodKind& kind) {
  return kind != kPaper && kind != lab::kPaperEq2 && kind != lab::kBdTree;
}

TEST(Methods, AgreeOnMorphedBodiesOrRefuseThem) {
  Random random(11);
  Shape limb = test::make_limb(16, 8, kJoints);
  test::add_morph_targets(random, limb, 7, 0.3, 0.1);
  const SkinnedModel model = model_of(limb);
  std::size_t touching = 0;
  for (int round = 0; round < 4; ++round) {
    const Scene scene = {
        {model, model},
        {bend_limb(random, kJoints, 0.3, {}), bend_limb(random, kJoints, 0.3, random.point(0.3))}};
    const auto weights = test::make_morph_weights(random, 7, test::Morphing::all);
    const auto answer = [&](const MethodKind& kind) {
      const auto method = method_with(kind, scene);
      EXPECT_TRUE(method->set_morph_weights(0, std::vector<float>(7)));
      EXPECT_EQ(bool(method->set_morph_weights(0, weights)), knows_morph_targets(kind));
      EXPECT_TRUE(method->set_palette(0, scene.palettes[0]));
      Contacts contacts;
      method->collide(0, 1, contacts, {});
      return contacts;
    };
    const Contacts expected = answer(kBrute);
    for (const MethodKind& kind : kKinds) {
      const Contacts contacts = answer(kind);
      if (knows_morph_targets(kind)) {
        EXPECT_EQ(contacts, expected) << kind.name;
      }
    }
    touching += !expected.empty();
  }
  EXPECT_GT(touching, 1u);
}

TEST(Methods, AreFoundByName) {
  const std::vector<std::string_view> names = names_of(kKinds);
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), std::size(kKinds));
  for (const MethodKind& kind : kKinds) EXPECT_EQ(find_method(kKinds, kind.name), kind);
  for (const MethodKind& kind : kCommandMethods) EXPECT_EQ(find_method(kKinds, kind.name), kind);
  EXPECT_EQ(find_method(kKinds, "paper_lazy"), std::nullopt);
  EXPECT_EQ(find_method(kCommandMethods, "rigid"), std::nullopt);
}

// Rigid bodies are built again for each palette, in whatever order palettes are set.

TEST(RigidMethod, AnswersForTheLastPaletteInAnyOrder) {
  Random random(1);
  const auto limb = build_model(test::make_limb(12, 8, kJoints).view());
  ASSERT_TRUE(limb);
  std::vector<std::vector<Matrix4>> palettes;
  for (int i = 0; i < 4; ++i)
    palettes.push_back(bend_limb(random, kJoints, 0.6, random.point(0.2)));
  const auto rigid = lab::make_rigid(), brute = make_brute();
  for (const auto& method : {rigid.get(), brute.get()}) {
    method->add(*limb);
    method->add(*limb);
  }
  int touching = 0;
  for (int step = 0; step < 60; ++step) {
    const auto body = static_cast<std::uint32_t>(random.index(2));
    const std::vector<Matrix4>& palette = palettes[random.index(4)];
    std::vector<Contact> found, expected;
    ASSERT_TRUE(rigid->set_palette(body, palette));
    ASSERT_TRUE(brute->set_palette(body, palette));
    rigid->collide(0, 1, found, {});
    brute->collide(0, 1, expected, {});
    ASSERT_EQ(found, expected) << step;
    touching += !found.empty();
  }
  std::printf("%d of 60 steps touch\n", touching);
  EXPECT_GT(touching, 20);
}

}  // namespace

}  // namespace pelt::methods
