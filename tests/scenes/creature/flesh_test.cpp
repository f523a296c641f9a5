#include "scenes/creature/flesh.hpp"

#include "scenes/creature/body_plan.hpp"
#include "scenes/creature/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt::scenes {
namespace {

Muscle muscle(const RoundCone& shape) { return {0, shape, 0.01, {}}; }

TEST(Flesh, DistanceToABall) {
  const Muscle ball = muscle({{1, 2, 3}, 0.5, {1, 2, 3}, 0.5});
  EXPECT_NEAR(muscle_distance(ball, {1, 2, 5}), 1.5, 1e-15);
  EXPECT_NEAR(muscle_distance(ball, {1, 2, 3}), -0.5, 1e-15);
}

// The distance to a union of balls is the least distance to any of them.
TEST(Flesh, DistanceToARoundConeIsThatToItsNearestBall) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE(kSeed);
  SplitMix64 random(kSeed);
  const auto point = [&] {
    return Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  };
  int inside = 0;
  for (int i = 0; i < 600; ++i) {
    RoundCone cone = {point(), random.between(0.05, 0.5), point(), 0};
    cone.radius_b = cone.radius_a * random.between(0.5, 1);
    if (length(cone.b - cone.a) <= cone.radius_a - cone.radius_b) continue;
    const Vec3d p = point();
    double least = 1e9;
    for (int s = 0; s <= 2000; ++s) {
      const double t = s / 2000.0;
      const double radius = cone.radius_a + t * (cone.radius_b - cone.radius_a);
      least = std::min(least, length(p - mix(cone.a, cone.b, t)) - radius);
    }
    inside += least < 0;
    EXPECT_NEAR(muscle_distance(muscle(cone), p), least, 1e-4);
    EXPECT_LE(muscle_distance(muscle(cone), p), least + 1e-12);
  }
  EXPECT_GT(inside, 20);
}

class WholeBody : public testing::Test {
 protected:
  BodyPlan plan_ = make_body_plan(draw_proportions(4));
  SplitMix64 random_{99};

  Vec3d random_point() {
    return {random_.between(-0.8, 0.8), random_.between(-0.1, 2), random_.between(-1, 0.6)};
  }
};

TEST_F(WholeBody, GradientIsTheSlopeOfTheDistance) {
  int near = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random_point();
    const FleshSample sample = sample_flesh(plan_.flesh, p);
    if (sample.distance < -0.03 || sample.distance > 0.1) continue;  // creases are deep inside
    ++near;
    const double h = 1e-6;
    const auto slope = [&](const Vec3d& d) {
      return (sample_flesh(plan_.flesh, p + h * d).distance -
              sample_flesh(plan_.flesh, p - h * d).distance) /
             (2 * h);
    };
    EXPECT_NEAR(sample.gradient.x, slope({1, 0, 0}), 2e-4);
    EXPECT_NEAR(sample.gradient.y, slope({0, 1, 0}), 2e-4);
    EXPECT_NEAR(sample.gradient.z, slope({0, 0, 1}), 2e-4);
  }
  EXPECT_GT(near, 150);
}

// `polygonise` and its pruning rely on this; it implies that leaving out far limbs causes no step.
TEST_F(WholeBody, DistanceChangesByAtMostTheWay) {
  for (int i = 0; i < 5000; ++i) {
    const Vec3d a = random_point();
    const Vec3d b = a + random_.between(0, 0.05) * unit(random_point() - a);
    const double change =
        sample_flesh(plan_.flesh, a).distance - sample_flesh(plan_.flesh, b).distance;
    EXPECT_LE(std::abs(change), length(b - a) + 1e-12);
  }
}

TEST_F(WholeBody, ProjectedPointsAreOnTheSurface) {
  int projected = 0;
  for (int i = 0; i < 6000; ++i) {
    Vec3d p = random_point();
    if (std::abs(sample_flesh(plan_.flesh, p).distance) > 0.01) continue;
    ++projected;
    EXPECT_NEAR(project_on_flesh(plan_.flesh, p).distance, 0, 1e-5);
    EXPECT_NEAR(sample_flesh(plan_.flesh, p).distance, 0, 1e-5);
  }
  EXPECT_GT(projected, 30);
}

TEST_F(WholeBody, NothingIsBelowTheGround) {
  for (int i = 0; i < 1000; ++i) {
    Vec3d p = random_point();
    p.y = random_.between(-0.05, -1e-6);
    EXPECT_GT(sample_flesh(plan_.flesh, p).distance, 0);
  }
}

}  // namespace
}  // namespace pelt::scenes
