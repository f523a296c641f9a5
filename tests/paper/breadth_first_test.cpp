#include "paper/breadth_first.hpp"
#include "paper/leaf_order.hpp"
#include "paper/on_demand.hpp"
#include "paper/posed_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::paper {
namespace {

using test::Random;

/// A limb under a palette, and its level of each node.
struct Body {
  explicit Body(const test::Shape& shape)
      : mesh(test::checked_mesh(shape)),
        model(build_sphere_model(mesh)),
        levels(model.tree.nodes.size(), 0),
        body(mesh, model) {
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
      for (std::uint32_t c = 0; c < model.tree.nodes[n].child_count; ++c)
        levels[model.tree.nodes[n].first_child + c] = levels[n] + 1;
  }

  SkinnedMesh mesh;
  SphereModel model;
  std::vector<int> levels;
  OnDemandBody body;
};

std::vector<Contact> sorted(std::vector<Contact> contacts) {
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

TEST(BreadthFirst, FindsTheContactsOfTheDepthFirstDescent) {
  Random random(71);
  Body a(test::make_limb(20, 9, 6)), b(test::make_limb(17, 8, 5));
  std::size_t touching = 0;
  for (int round = 0; round < 30; ++round) {
    const Vec3 place = random.point(0.15);
    const double bend_a = random.uniform(-0.5, 0.5), bend_b = random.uniform(-0.5, 0.5);
    const Palette palette_a = test::checked_palette(a.mesh, bend_limb(random, 6, bend_a, {}));
    const Palette palette_b = test::checked_palette(b.mesh, bend_limb(random, 5, bend_b, place));
    a.body.invalidate();
    b.body.invalidate();
    Scratch scratch;
    std::vector<Contact> expected, found;
    const QueryStats work = collide(a.body, palette_a, b.body, palette_b, scratch, expected,
                                    std::numeric_limits<std::uint32_t>::max());
    OnDemandBody::Side side_a(a.body, palette_a), side_b(b.body, palette_b);
    BreadthFirst search(side_a, side_b, scratch, found);
    while (!search.is_complete()) search.step();
    ASSERT_EQ(sorted(found), sorted(expected));
    ASSERT_EQ(search.stats().node_pairs, work.node_pairs);
    ASSERT_EQ(search.stats().triangle_pairs, work.triangle_pairs);
    touching += !expected.empty();
  }
  EXPECT_GT(touching, 10u);
}

/// Missing contacts are below pairs that wait, and the levels of these pairs differ by at most one.
TEST(BreadthFirst, TakesOneLevelAfterTheOther) {
  Random random(72);
  Body a(test::make_limb(20, 9, 6)), b(test::make_limb(17, 8, 5));
  const Palette palette_a = test::checked_palette(a.mesh, bend_limb(random, 6, 0.3, {}));
  const Palette palette_b = test::checked_palette(b.mesh, bend_limb(random, 5, -0.2, {0.1f, 0, 0}));
  OnDemandBody::Side side_a(a.body, palette_a), side_b(b.body, palette_b);
  Scratch scratch;
  std::vector<Contact> contacts;
  BreadthFirst search(side_a, side_b, scratch, contacts);
  std::uint64_t undecided = std::numeric_limits<std::uint64_t>::max(), steps = 0;
  for (; !search.is_complete(); search.step(), ++steps) {
    int lowest = std::numeric_limits<int>::max(), highest = 0;
    std::uint64_t pairs = 0;
    search.each_open([&](std::uint32_t node_a, std::uint32_t node_b) {
      const int level = a.levels[node_a] + b.levels[node_b];
      lowest = std::min(lowest, level);
      highest = std::max(highest, level);
      pairs += std::uint64_t{a.model.tree.nodes[node_a].triangle_count} *
               b.model.tree.nodes[node_b].triangle_count;
    });
    ASSERT_LE(highest, lowest + 1);
    ASSERT_LE(pairs, undecided);
    undecided = pairs;
  }
  EXPECT_GT(contacts.size(), 20u);
  EXPECT_GT(steps, 200u);
}

void expect_same_vertex(const SkinnedMesh& mesh, std::uint32_t v, const SkinnedMesh& ordered,
                        std::uint32_t w) {
  ASSERT_EQ(ordered.rest_positions[w], mesh.rest_positions[v]);
  const auto expected = mesh.influences_of(v), actual = ordered.influences_of(w);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_EQ(actual[i].joint, expected[i].joint);
    ASSERT_EQ(actual[i].weight, expected[i].weight);
  }
}

TEST(LeafOrder, KeepsEveryTriangleUnderTheNumberOfItsLeaf) {
  const SkinnedMesh mesh = test::checked_mesh(test::make_limb(20, 9, 6));
  const SphereTree tree = build_sphere_tree(mesh.rest_positions, mesh.triangles);
  const SkinnedMesh ordered = in_leaf_order(mesh, tree);
  ASSERT_EQ(ordered.triangle_count(), mesh.triangle_count());
  std::uint32_t used = 0;  // vertices are numbered in the order in which triangles use them
  for (std::uint32_t t = 0; t < ordered.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t w = ordered.triangles[t][k];
      expect_same_vertex(mesh, mesh.triangles[tree.triangle_order[t]][k], ordered, w);
      ASSERT_LE(w, used);
      used += w == used;
    }
  EXPECT_EQ(used, ordered.vertex_count());
}

}  // namespace
}  // namespace pelt::paper
