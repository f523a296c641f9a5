/// Rigid and static meshes: models with one joint, prepared like any other model, that are collided
/// with, hit by rays, and moved by one matrix.

#include "geometry/ray_triangle.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <pelt/collide.hpp>
#include <pelt/model.hpp>
#include <pelt/ray.hpp>

#include <gtest/gtest.h>

namespace pelt {
namespace {

using test::Random;
using test::Shape;

std::vector<Vec3> posed(const Pose& pose) {
  std::vector<Vec3> positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

/// A rock, once built and once read from bytes.
struct Rocks {
  explicit Rocks(Random& random)
      : shape(test::make_soup(random, 300, 1, 1, test::Weights::one_joint)),
        built(*build_model(shape.view())),
        read(*load_model(save_model(built.model()))) {}

  void move(const Matrix4& matrix) {
    ASSERT_TRUE(built.set_palette(std::span(&matrix, 1)));
    ASSERT_TRUE(read.set_palette(std::span(&matrix, 1)));
  }

  Shape shape;
  Pose built, read;
};

TEST(StaticMesh, CollidesWithCharactersLikeBruteForce) {
  Random random(750);
  Rocks rocks(random);
  const Shape limb = test::make_limb(20, 8, 4);
  Pose character(*build_model(limb.view()));
  Scratch scratch;
  std::size_t touching = 0;
  for (int round = 0; round < 80; ++round) {
    if (round % 10 == 0)
      rocks.move(test::rotation_about(random.point(1), random.uniform(0, 6), {}, random.point(1)));
    ASSERT_TRUE(character.set_palette(test::bend_limb(random, 4, 0.5, random.point(1))));
    std::vector<Contact> expected;
    methods::brute_force_collide(limb.triangles, posed(character), rocks.shape.triangles,
                                 posed(rocks.built), expected, UINT32_MAX);
    for (Pose* rock : {&rocks.built, &rocks.read}) {
      std::vector<Contact> contacts;
      collide(character, *rock, scratch, contacts);
      EXPECT_EQ(contacts, expected);
    }
    touching += !expected.empty();
  }
  EXPECT_GT(touching, 30u);
}

RayHit brute_force_cast(const Rocks& rocks, const Ray& ray) {
  const auto positions = posed(rocks.built);
  RayHit best;
  for (std::uint32_t t = 0; t < rocks.shape.triangles.size(); ++t) {
    const auto [a, b, c] = rocks.shape.triangles[t];
    detail::RayCrossing crossing;
    if (!line_meets_triangle({ray.origin, ray.direction},
                             {positions[a], positions[b], positions[c]}, crossing))
      continue;
    if (crossing.t < ray.t_min || crossing.t > ray.t_max || best.t <= crossing.t) continue;
    best.triangle = t;
    best.t = crossing.t;
  }
  return best;
}

TEST(StaticMesh, IsHitByRaysLikeBruteForce) {
  Random random(751);
  Rocks rocks(random);
  int hits = 0;
  for (int round = 0; round < 400; ++round) {
    if (round % 20 == 0)
      rocks.move(test::rotation_about(random.point(1), random.uniform(0, 6), {}, random.point(1)));
    const Ray ray = segment(random.point(3), random.point(2));
    const RayHit expected = brute_force_cast(rocks, ray);
    for (Pose* rock : {&rocks.built, &rocks.read}) {
      const RayHit hit = test::first_hit(*rock, ray);
      EXPECT_EQ(hit.triangle, expected.triangle);
      EXPECT_EQ(hit.t, expected.t);
    }
    hits += bool(expected);
  }
  EXPECT_GT(hits, 100);
}

/// Opened nodes of a mesh stay open while it does not move.
TEST(StaticMesh, IsPosedOnceWhileItStands) {
  Random random(752);
  Rocks rocks(random);
  const Shape limb = test::make_limb(20, 8, 4);
  Pose character(*build_model(limb.view()));
  Scratch scratch;
  std::vector<Contact> contacts;
  const auto palette = test::bend_limb(random, 4, 0.5, {});
  ASSERT_TRUE(character.set_palette(palette));
  const QueryStats first = collide(character, rocks.built, scratch, contacts);
  ASSERT_TRUE(character.set_palette(palette));
  const QueryStats second = collide(character, rocks.built, scratch, contacts);
  EXPECT_GT(second.posed_vertices, 0u);
  EXPECT_LT(second.posed_vertices, first.posed_vertices);
  EXPECT_FALSE(contacts.empty());
}

}  // namespace
}  // namespace pelt
