#include <pelt/distance.hpp>

#include "distance/brute_distance.hpp"
#include "query/answers.hpp"
#include "support/animated_character.hpp"
#include "support/brute_force.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pelt {
namespace {

using detail::point_at;
using test::brute_distance;
using test::BruteDistance;
using test::LimbPair;
using test::posed_triangles;
using test::Random;
using test::same;
using test::Shape;

Distance distance_of(Pose& a, Pose& b, Scratch& scratch, const DistanceOptions& options = {}) {
  Distance closest;
  distance(a, b, scratch, closest, options);
  return closest;
}

void expect_equal(const Distance& found, const BruteDistance& expected) {
  ASSERT_EQ(found.distance, expected.distance);
  ASSERT_EQ(found.lower_bound, expected.distance);
  ASSERT_EQ(found.a.triangle, expected.triangle_a);
  ASSERT_EQ(found.b.triangle, expected.triangle_b);
}

TEST(Distance, IsAnIntervalAfterAnyAmountOfWork) {
  Random random(123);
  LimbPair limbs;
  int cut = 0, touching = 0, bounded_below = 0, bounded_above = 0;
  for (int round = 0; round < 40; ++round) {
    limbs.move(random, round % 3 == 0 ? 0.2 : 1);
    const double expected = brute_distance(limbs.triangles_a(), limbs.triangles_b()).distance;
    touching += expected == 0;
    for (const double tolerance : {0.0, 0.01})
      for (std::uint64_t work = 1;; work *= 2) {
        limbs.a.reserve();  // closes the nodes, which cost work
        limbs.b.reserve();
        Distance closest;
        const bool is_cut = distance(limbs.a, limbs.b, limbs.scratch, closest,
                                     {.tolerance = tolerance, .max_work = work})
                                .cut_short;
        ASSERT_LE(closest.lower_bound, expected);
        ASSERT_GE(closest.distance, expected);
        if (!is_cut) {
          ASSERT_LE(closest.distance - closest.lower_bound, tolerance * (1 + 1e-12));
          break;
        }
        ++cut;
        bounded_below += closest.lower_bound > 0.5 * expected;
        bounded_above += closest && closest.distance > expected;
      }
  }
  EXPECT_GT(touching, 4);
  EXPECT_GT(cut, 300);
  EXPECT_GT(bounded_below, 20);
  EXPECT_GT(bounded_above, 20);
}

/// Flat triangles, one for each three points, moved by one joint.
Shape flat_shape(const std::vector<Vec3>& corners) {
  Shape shape;
  shape.rest_positions = corners;
  shape.influences_per_vertex = 1;
  for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3)
    shape.triangles.push_back({i, i + 1, i + 2});
  shape.joints.resize(corners.size(), 0);
  shape.weights.resize(corners.size(), 1);
  return shape;
}

double distance_of_shapes(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Pose pose_a(*build_model(flat_shape(a).view())), pose_b(*build_model(flat_shape(b).view()));
  Scratch scratch;
  return distance_of(pose_a, pose_b, scratch).distance;
}

TEST(Distance, IsZeroOnlyWhereTrianglesTouch) {
  const std::vector<Vec3> t = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(distance_of_shapes(t, {{0, 0, 0}, {0, 0, 3}, {-1, 0, 3}}), 0) << "one corner";
  EXPECT_EQ(distance_of_shapes(t, {{1, 1, 0}, {1, 1, 3}, {2, 1, 3}}), 0) << "corner on face";
  EXPECT_EQ(distance_of_shapes(t, {{1, 1, -1}, {1, 1, 3}, {9, 9, 3}}), 0) << "pierced";
  EXPECT_EQ(distance_of_shapes(t, {{1, 1, 0}, {9, 1, 0}, {1, 9, 0}}), 0) << "coplanar";
  EXPECT_EQ(distance_of_shapes(t, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}), 0) << "a point";
  EXPECT_EQ(distance_of_shapes(t, {{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}), 2) << "a point above";
  EXPECT_EQ(distance_of_shapes(t, {{-3, 0, 0}, {-9, 0, 0}, {-9, 4, 0}}), 3) << "coplanar, apart";
  EXPECT_EQ(distance_of_shapes(t, {{1, -9, 5}, {1, 9, 5}, {1, 9, 9}}), 5) << "edge over face";
  const float least = 0x1p-149f;
  EXPECT_EQ(distance_of_shapes(t, {{1, 1, least}, {1, 1, 3}, {2, 1, 3}}), 0x1p-149);
}

TEST(Distance, OfABodyInsideAnotherIsNotZero) {
  const Shape limb = test::make_limb(24, 10, 5);
  Pose outer(*build_model(limb.view())), inner(outer.model());
  std::vector<Matrix4> shrunk(5);
  for (Matrix4& m : shrunk) m.m[0] = m.m[5] = m.m[10] = 0.25f, m.m[13] = 0.3f;
  ASSERT_TRUE(inner.set_palette(shrunk));
  Scratch scratch;
  const Distance closest = distance_of(outer, inner, scratch);
  EXPECT_GT(closest.distance, 0.001);
  expect_equal(closest, brute_distance(posed_triangles(limb.triangles, outer),
                                       posed_triangles(limb.triangles, inner)));
}

/// Two limbs, scaled by `scale` and translated by `shift` from the origin.
void expect_brute_force_at(double scale, double shift, double apart, std::uint64_t seed) {
  Random random(seed);
  LimbPair limbs;
  const auto placed = [&](std::vector<Matrix4> palette, double x) {
    for (Matrix4& m : palette) {
      for (float& e : m.m) e = static_cast<float>(e * scale);
      m.m[12] += static_cast<float>(x + shift), m.m[14] += static_cast<float>(shift), m.m[15] = 1;
      m.m[3] = m.m[7] = m.m[11] = 0;
    }
    return palette;
  };
  for (int round = 0; round < 5; ++round) {
    ASSERT_TRUE(limbs.a.set_palette(placed(test::bend_limb(random, 5, 0.4, {}), 0)));
    ASSERT_TRUE(limbs.b.set_palette(placed(test::bend_limb(random, 4, 0.4, {}), apart * scale)));
    const BruteDistance expected = brute_distance(limbs.triangles_a(), limbs.triangles_b());
    EXPECT_GT(expected.distance, 0);
    expect_equal(distance_of(limbs.a, limbs.b, limbs.scratch), expected);
  }
}

TEST(Distance, HugeTinyAndFarFromTheOrigin) {
  expect_brute_force_at(0x1p50, 0, 2, 112);
  expect_brute_force_at(0x1p-50, 0, 2, 113);
  expect_brute_force_at(1, 1000, 2, 114);
  expect_brute_force_at(1, 100000, 1.5, 115);
}

TEST(Distance, HintsAndEarlierQueriesChangeNoAnswer) {
  Random random(117);
  LimbPair limbs;
  Distance last;
  std::uint64_t without = 0, with = 0;
  for (int round = 0; round < 40; ++round) {
    const auto palette_a = test::bend_limb(random, 5, 0.3, {});
    const auto palette_b = test::bend_limb(random, 4, 0.3, random.point(2));
    Distance answers[4];
    const auto fresh = [&] {
      ASSERT_TRUE(limbs.a.set_palette(palette_a));
      ASSERT_TRUE(limbs.b.set_palette(palette_b));
    };
    fresh();
    without += distance(limbs.a, limbs.b, limbs.scratch, answers[0]).triangle_pairs;
    with += distance(limbs.a, limbs.b, limbs.scratch, answers[1], {.hint = answers}).triangle_pairs;
    Distance wild;
    wild.location = detail::Access::location<4>(
        {static_cast<std::uint32_t>(random.bits()), 3, random.index(9), random.index(9)});
    fresh();
    distance(limbs.a, limbs.b, limbs.scratch, answers[2], {.hint = round % 2 ? &wild : &last});
    fresh();
    ClosestPoint closest;
    closest_point(limbs.a, random.point(1), limbs.scratch, closest);
    is_within(limbs.b, limbs.a, 0.1, limbs.scratch);
    distance(limbs.a, limbs.b, limbs.scratch, answers[3]);
    for (const Distance& answer : answers) ASSERT_TRUE(same(answer, answers[0]));
    last = answers[0];
  }
  EXPECT_LT(with, without);
}

TEST(Distance, WitnessesHaveTheDistance) {
  Random random(119);
  LimbPair limbs;
  int touching = 0;
  for (int round = 0; round < 60; ++round) {
    limbs.move(random, round % 2 ? 2 : 0.2);
    const Distance closest = distance_of(limbs.a, limbs.b, limbs.scratch);
    const detail::Vec3d way = detail::Vec3d(closest.a.position) - detail::Vec3d(closest.b.position);
    EXPECT_NEAR(std::sqrt(squared_length(way)), closest.distance, 1e-6);
    const auto corners = limbs.triangles_a()[closest.a.triangle];
    const auto& at = closest.a.barycentrics;
    const detail::Vec3d p = point_at(corners, {at[0], at[1], at[2]});
    EXPECT_NEAR(std::sqrt(squared_length(p - detail::Vec3d(closest.a.position))), 0, 1e-6);
    touching += closest.distance == 0;
  }
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 50);
}

TEST(Distance, BeyondTheMaximumNothingIsFound) {
  Random random(120);
  LimbPair limbs;
  for (int round = 0; round < 30; ++round) {
    limbs.move(random, 3);
    const Distance exact = distance_of(limbs.a, limbs.b, limbs.scratch);
    if (exact.distance == 0) continue;
    EXPECT_TRUE(same(
        exact, distance_of(limbs.a, limbs.b, limbs.scratch, {.max_distance = exact.distance})));
    const double less = std::nextafter(exact.distance, 0);
    const Distance none = distance_of(limbs.a, limbs.b, limbs.scratch, {.max_distance = less});
    EXPECT_FALSE(none);
    EXPECT_EQ(none.lower_bound, less);
  }
  ASSERT_TRUE(limbs.b.set_palette(test::bend_limb(random, 4, 0.1, {50, 0, 0})));
  Distance far;
  const QueryStats stats = distance(limbs.a, limbs.b, limbs.scratch, far, {.max_distance = 40});
  EXPECT_FALSE(far);
  EXPECT_EQ(stats.posed_vertices, 0u) << "boxes of whole poses say it";
}

TEST(Distance, ToleranceSavesWorkAndProvesALowerBound) {
  Random random(121);
  LimbPair limbs;
  std::uint64_t exact_work = 0, work = 0;
  for (int round = 0; round < 30; ++round) {
    const auto palette_a = test::bend_limb(random, 5, 0.3, {});
    const auto palette_b = test::bend_limb(random, 4, 0.3, {1.5f, 0, 0});
    Distance exact, rough;
    ASSERT_TRUE(limbs.a.set_palette(palette_a) && limbs.b.set_palette(palette_b));
    exact_work += distance(limbs.a, limbs.b, limbs.scratch, exact).node_pairs;
    ASSERT_TRUE(limbs.a.set_palette(palette_a) && limbs.b.set_palette(palette_b));
    work += distance(limbs.a, limbs.b, limbs.scratch, rough, {.tolerance = 0.2}).node_pairs;
    EXPECT_GE(rough.distance, exact.distance);
    EXPECT_LE(rough.distance, exact.distance + 0.2);
    EXPECT_LE(rough.lower_bound, exact.distance);
    EXPECT_GE(rough.lower_bound, rough.distance - 0.2);
  }
  EXPECT_LT(work, exact_work);
}

std::vector<Contact> clearance_of(Pose& a, Pose& b, double tolerance, Scratch& scratch) {
  std::vector<Contact> pairs;
  clearance(a, b, tolerance, scratch, pairs);
  return pairs;
}

TEST(Clearance, OfZeroIsCollide) {
  Random random(142);
  LimbPair limbs;
  std::size_t seen = 0;
  for (int round = 0; round < 50; ++round) {
    limbs.move(random, 0.2);
    std::vector<Contact> contacts;
    collide(limbs.a, limbs.b, limbs.scratch, contacts);
    ASSERT_EQ(clearance_of(limbs.a, limbs.b, 0, limbs.scratch), contacts);
    seen += contacts.size();
  }
  EXPECT_GT(seen, 200u);
}

TEST(Clearance, BeginsAtTheDistance) {
  Random random(143);
  LimbPair limbs;
  int apart = 0;
  for (int round = 0; round < 40; ++round) {
    limbs.move(random, 2);
    Distance closest;
    distance(limbs.a, limbs.b, limbs.scratch, closest);
    if (closest.distance == 0) continue;
    ++apart;
    const double less = std::nextafter(closest.distance, 0);
    EXPECT_FALSE(is_within(limbs.a, limbs.b, less, limbs.scratch));
    EXPECT_TRUE(is_within(limbs.a, limbs.b, closest.distance, limbs.scratch));
    const auto pairs = clearance_of(limbs.a, limbs.b, closest.distance, limbs.scratch);
    ASSERT_FALSE(pairs.empty());
    EXPECT_EQ(pairs[0], (Contact{closest.a.triangle, closest.b.triangle}));
  }
  EXPECT_GT(apart, 20);
}

TEST(ClosestPoint, BeyondTheMaximumNothingIsFound) {
  Random random(132);
  LimbPair limbs;
  limbs.move(random, 0);
  for (int i = 0; i < 50; ++i) {
    const Vec3 point = random.point(4);
    ClosestPoint exact, closest;
    closest_point(limbs.a, point, limbs.scratch, exact);
    closest_point(limbs.a, point, limbs.scratch, closest, {.max_distance = exact.distance});
    EXPECT_EQ(closest.distance, exact.distance);
    EXPECT_EQ(closest.point.triangle, exact.point.triangle);
    closest_point(limbs.a, point, limbs.scratch, closest,
                  {.max_distance = std::nextafter(exact.distance, 0)});
    EXPECT_FALSE(closest);
  }
}

TEST(ClosestPoint, OpensFewNodes) {
  const Shape limb = test::make_limb(200, 40, 5);
  Pose pose(*build_model(limb.view()));
  Scratch scratch;
  ClosestPoint closest;
  const QueryStats stats = closest_point(pose, {0.3f, 0.4f, 0}, scratch, closest);
  EXPECT_TRUE(closest);
  EXPECT_LT(stats.posed_vertices, limb.rest_positions.size() / 4);
  EXPECT_LT(stats.triangle_pairs, 200u);
}

// Real characters, compared with brute force over all their posed triangles.

struct Case {
  std::string model;
  double metre;  ///< one metre in units of the model
};

using DistanceOfModels = test::OfSharedModels<Case>;

TEST_P(DistanceOfModels, EqualsBruteForce) {
  const asset::Asset& asset = character->asset;
  Pose& a = character->pose;
  Pose b(a.model());
  Scratch scratch;
  for (const double metres : {0.5, 1.0, 2.5}) {
    const auto seconds = static_cast<float>(metres);
    character->move(character->first_clip(), seconds);
    Matrix4 shifted;
    shifted.m[12] = static_cast<float>(metres * GetParam().metre);
    shifted.m[14] = shifted.m[12] / 3;
    character->move(b, character->first_clip(), seconds + 0.3f, shifted);
    const BruteDistance expected =
        brute_distance(posed_triangles(asset.triangles, a), posed_triangles(asset.triangles, b));
    Distance closest;
    distance(a, b, scratch, closest);
    EXPECT_EQ(closest.distance, expected.distance);
    EXPECT_EQ(closest.a.triangle, expected.triangle_a);
    EXPECT_EQ(closest.b.triangle, expected.triangle_b);
    std::vector<Contact> contacts;
    std::vector<Contact> touching;
    collide(a, b, scratch, contacts);
    clearance(a, b, 0, scratch, touching);
    EXPECT_EQ(touching, contacts);
    EXPECT_EQ(closest.distance == 0, !contacts.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, DistanceOfModels,
                         testing::Values(Case{"knight.glb", 3}, Case{"cesium_man.glb", 1},
                                         Case{"fox_khronos.glb", 100}, Case{"spider.glb", 1}),
                         test::kStemOfModel);

}  // namespace
}  // namespace pelt
