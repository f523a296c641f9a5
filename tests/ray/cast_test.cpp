#include <pelt/ray.hpp>

#include "ray_cases.hpp"
#include "ray_oracle.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

constexpr Facing kFacings[] = {Facing::both, Facing::front, Facing::back};

/// A posed shape and the expected hits of rays.
struct Posed {
  Posed(const Shape& s, const std::vector<Matrix4>& palette)
      : shape(s), pose(*build_model(shape.view())), oracle(shape.triangles, set(pose, palette)) {}

  static const Pose& set(Pose& pose, const std::vector<Matrix4>& palette) {
    EXPECT_TRUE(pose.set_palette(palette));
    EXPECT_TRUE(
        pose.set_morph_weights(std::vector<float>(pose.model().morph_target_count(), 0.7f)));
    return pose;
  }

  RayCases cases() const { return {shape.triangles, oracle.positions()}; }

  Shape shape;
  Pose pose;
  RayOracle oracle;
};

/// The number of rays by their number of hit triangles.
struct HitCounts {
  int none = 0, one = 0, several = 0;

  void add(std::size_t hits) { ++(hits == 0 ? none : hits == 1 ? one : several); }
  void expect_each_at_least(int count) const {
    EXPECT_GE(none, count);
    EXPECT_GE(one, count);
    EXPECT_GE(several, count);
  }
};

TEST(Cast, FindsWhatALimbHas) {
  Posed limb(make_limb(24, 10, 5), std::vector<Matrix4>(5));
  const Ray through = {{-5, 0.5f, 0.01f}, {2, 0, 0}};
  const RayHit first = test::first_hit(limb.pose, through);
  ASSERT_TRUE(first);
  EXPECT_LT(first.normal.x, 0);
  EXPECT_GT(first.t, 2);
  EXPECT_FALSE(test::first_hit(limb.pose, {{-5, 0.5f, 0.01f}, {-2, 0, 0}}));
  EXPECT_FALSE(test::first_hit(limb.pose, {{-5, 0.5f, 0.01f}, {0, 0, 0}})) << "no direction";
  EXPECT_FALSE(test::first_hit(limb.pose, {{-5, 0.5f, 0.01f}, {2, 0, 0}, 0, 1}));
  Scratch scratch;
  std::vector<RayHit> all;
  cast_all(limb.pose, through, scratch, all);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0], first);
  EXPECT_EQ(test::first_hit(limb.pose, through, Facing::back), all[1]);
}

/// Joints that make a mesh tiny or huge, and rays of any length from near and far.
TEST(Cast, EqualsBruteForceOnMeshesOfAllSizes) {
  Random random(92);
  Scratch scratch;
  HitCounts counts;
  for (const int exponent : {-100, -60, -20, 20, 56}) {
    std::vector<Matrix4> palette = bend_limb(random, 5, 0.5, {});
    for (Matrix4& matrix : palette)
      for (std::size_t i = 0; i < 15; ++i)
        if (i % 4 != 3) matrix.m[i] = std::ldexp(matrix.m[i], exponent);
    Posed limb(make_limb(24, 10, 5), palette);
    const RayCases cases = limb.cases();
    for (int i = 0; i < 300; ++i) {
      Ray ray = cases.next(random);
      if (random.chance(0.2)) ray.origin = random.point(1e30);
      counts.add(expect_as_oracle(limb.pose, limb.oracle, ray, scratch));
    }
  }
  counts.expect_each_at_least(40);
}

/// Vertices on a grid, so that rays run along edges and in planes of triangles and boxes.
TEST(Cast, EqualsBruteForceOnGrids) {
  Random random(93);
  Scratch scratch;
  HitCounts counts;
  const auto grid_point = [&](int least, int most) {
    const auto coordinate = [&] {
      return static_cast<float>(least + static_cast<int>(random.index(most - least + 1)));
    };
    const float x = coordinate(), y = coordinate();
    return Vec3{x, y, coordinate()};
  };
  for (int round = 0; round < 30; ++round) {
    Shape shape = make_soup(random, 100, 3, 1, Weights::one_joint);
    for (Vec3& p : shape.rest_positions) p = grid_point(0, 4);
    Posed grid(shape, std::vector<Matrix4>(3));
    for (int i = 0; i < 200; ++i)
      counts.add(expect_as_oracle(grid.pose, grid.oracle,
                                  {grid_point(-1, 5), grid_point(-2, 2), -4, 4}, scratch));
  }
  counts.expect_each_at_least(150);
}

TEST(Cast, DoesNotDependOnEarlierQueriesOrTheInstructionSet) {
  Random random(94);
  const Posed made(make_limb(60, 24, 5), bend_limb(random, 5, 0.5, {}));
  std::vector<Ray> rays;
  for (int i = 0; i < 2'000; ++i) rays.push_back(made.cases().next(random));
  std::vector<RayHit> expected(rays.size()), found(rays.size());
  Posed together(made.shape, bend_limb(random, 5, 0.5, {}));
  std::vector<Matrix4> palette = bend_limb(random, 5, 0.5, {});
  ASSERT_TRUE(together.pose.set_palette(palette));
  cast(together.pose, rays, expected);
  on_each_instruction_set([&](InstructionSet) {
    ASSERT_TRUE(together.pose.set_palette(palette));
    for (std::size_t i = rays.size(); i-- > 0;) found[i] = test::first_hit(together.pose, rays[i]);
    EXPECT_EQ(found, expected);
    for (std::size_t i = 0; i < rays.size(); i += 20) {
      ASSERT_TRUE(together.pose.set_palette(palette));
      EXPECT_EQ(test::first_hit(together.pose, rays[i]), expected[i]);
    }
  });
  EXPECT_GT(std::count_if(expected.begin(), expected.end(),
                          [](const RayHit& hit) { return static_cast<bool>(hit); }),
            500);
}

TEST(Cast, ChoosesTheLowestTriangleOfAnEdge) {
  Random random(95);
  Posed limb(make_limb(24, 10, 5), bend_limb(random, 5, 0.4, {}));
  int shared = 0;
  Scratch scratch;
  for (int i = 0; i < 500; ++i) {
    const Vec3& corner = limb.oracle.positions()[random.index(limb.pose.model().vertex_count())];
    const Ray ray = {{10, corner.y, corner.z}, {-1, 0, 0}};
    std::vector<RayHit> all;
    cast_all(limb.pose, ray, scratch, all);
    const RayHit first = test::first_hit(limb.pose, ray);
    std::uint32_t lowest = kNoTriangle;
    std::uint32_t alike = 0;
    for (const RayHit& hit : all)
      if (hit.t == all[0].t) lowest = std::min(lowest, hit.triangle), ++alike;
    ASSERT_EQ(first.triangle, lowest);
    shared += alike > 2;
  }
  EXPECT_GT(shared, 20);
}

/// The far side of a body is not opened, and a ray that misses the body opens nothing.
TEST(Cast, OpensLittle) {
  Posed limb(make_limb(400, 40, 5), std::vector<Matrix4>(5));
  const Ray ray = {{-5, 0.51f, 0.013f}, {1, 0, 0}};
  RayHit hit;
  const QueryStats first = cast(limb.pose, std::span(&ray, 1), std::span(&hit, 1));
  EXPECT_TRUE(hit);
  EXPECT_LT(first.posed_vertices, limb.shape.rest_positions.size() / 20);
  EXPECT_LT(first.triangle_pairs, 200u);
  const QueryStats again = cast(limb.pose, std::span(&ray, 1), std::span(&hit, 1));
  EXPECT_EQ(again.posed_vertices, 0u);
  EXPECT_EQ(again.node_pairs, first.node_pairs);
  const Ray past = {{-5, 50, 0}, {1, 0, 0}};
  ASSERT_TRUE(limb.pose.set_palette(std::vector<Matrix4>(5)));
  const QueryStats missed = cast(limb.pose, std::span(&past, 1), std::span(&hit, 1));
  EXPECT_FALSE(hit);
  EXPECT_EQ(missed.posed_vertices, 0u);
  EXPECT_EQ(missed.node_pairs, 1u);
}

/// Once many rays have opened many nodes, the rest is opened at once; rays at one place open few.
TEST(Cast, OpensAllWhenManyRaysNeedMuch) {
  Random random(98);
  Posed limb(make_limb(200, 30, 5), bend_limb(random, 5, 0.4, {}));
  std::vector<Ray> everywhere, at_one_place(3'000);
  for (int i = 0; i < 3'000; ++i)
    everywhere.push_back(segment(random.point(20), limb.cases().target(random)));
  std::fill(at_one_place.begin(), at_one_place.end(), everywhere[0]);
  std::vector<RayHit> hits(3'000), again(3'000);
  const QueryStats all = cast(limb.pose, everywhere, hits);
  const std::vector<Matrix4> palette = bend_limb(random, 5, 0.4, {});
  Posed fresh(limb.shape, palette);
  const QueryStats few = cast(fresh.pose, at_one_place, again);
  EXPECT_GE(all.posed_vertices, limb.pose.model().vertex_count());
  EXPECT_LT(few.posed_vertices, limb.pose.model().vertex_count() / 8);
  cast(limb.pose, everywhere, again);
  EXPECT_EQ(again, hits);
  Scratch scratch;
  for (std::size_t i = 0; i < 200; ++i)
    expect_as_oracle(limb.pose, limb.oracle, everywhere[i], scratch);
}

TEST(Cast, BlendsTheJointsOfAHit) {
  Random random(97);
  Posed soup(make_soup(random, 300, 12, 4, Weights::random),
             make_palette(random, 12, Motion::rigid, 0.1));
  int hits = 0;
  std::vector<JointShare> shares;
  for (int i = 0; i < 400; ++i) {
    const RayHit hit = test::first_hit(soup.pose, soup.cases().next(random));
    if (!hit) continue;
    ++hits;
    shares.clear();
    influences_at(soup.pose.model(), hit, shares);
    std::vector<double> expected(12);
    const SkinnedMeshView mesh = soup.shape.view();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = mesh.triangles[hit.triangle][k];
      double sum = 0;
      for (std::size_t j = 0; j < 4; ++j) sum += double{mesh.weights[4 * vertex + j]};
      for (std::size_t j = 0; j < 4; ++j)
        expected[mesh.joints[4 * vertex + j]] +=
            double{hit.barycentrics[k]} * double{mesh.weights[4 * vertex + j]} / sum;
    }
    for (const JointShare& share : shares) {
      EXPECT_NEAR(double{share.share}, expected[share.joint], 1e-5);
      EXPECT_GT(share.share, 0);
      expected[share.joint] = 0;
    }
    for (const double left : expected) EXPECT_LT(left, 1e-6);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
      return a.share > b.share || (a.share == b.share && a.joint < b.joint);
    }));
  }
  EXPECT_GT(hits, 50);
}

}  // namespace
}  // namespace pelt::test
