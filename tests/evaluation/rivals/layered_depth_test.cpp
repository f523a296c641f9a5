/// Compares images with the exact answer. Images are not always right, but must answer no for
/// bodies whose boxes do not overlap, and yes for bodies that overlap deeply.

#include "evaluation/rivals/layered_depth.hpp"

#include "evaluation/rivals/posed_bodies.hpp"

#include <gtest/gtest.h>

namespace pelt::rivals {
namespace {

using test::PosedBodies;
using test::PosedBody;
using test::Positions;
using test::Random;

/// A closed, bumpy ball about `centre`.
PosedBody bumpy_ball(Random& random, const Vec3& centre, double radius) {
  constexpr std::uint32_t kRings = 9, kSides = 12;
  PosedBody body;
  Positions points;
  const auto add = [&](double turn, double height) {
    const double r = radius * random.uniform(0.7, 1), flat = std::sqrt(1 - height * height);
    points.push_back({centre.x + static_cast<float>(r * flat * std::cos(turn)),
                      centre.y + static_cast<float>(r * height),
                      centre.z + static_cast<float>(r * flat * std::sin(turn))});
  };
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t side = 0; side < kSides; ++side)
      add(side * 6.283185307 / kSides, (ring + 1.0) * 2 / (kRings + 1) - 1);
  add(0, -1), add(0, 1);
  const std::uint32_t bottom = kRings * kSides, top = bottom + 1;
  for (std::uint32_t s = 0; s < kSides; ++s) {
    const std::uint32_t next = (s + 1) % kSides, last = (kRings - 1) * kSides;
    body.triangles.push_back({bottom, s, next});
    body.triangles.push_back({top, last + next, last + s});
    for (std::uint32_t at = 0; at < last; at += kSides) {
      body.triangles.push_back({at + s, at + kSides + s, at + next});
      body.triangles.push_back({at + next, at + kSides + s, at + kSides + next});
    }
  }
  body.frames = {points};
  return body;
}

bool touch(const PosedBodies& bodies, std::uint32_t resolution) {
  LayeredDepth method(resolution);
  method.add(bodies.a.triangles);
  method.add(bodies.b.triangles);
  method.update(0, bodies.a.frames[0]);
  method.update(1, bodies.b.frames[0]);
  EXPECT_EQ(method.touch(0, 1), method.touch(1, 0));
  return method.touch(0, 1);
}

struct Errors {
  int missed = 0, invented = 0;
};

TEST(LayeredDepth, MissesLessTheFinerItIs) {
  Random random(1);
  constexpr int kPairs = 300;
  constexpr std::uint32_t kResolutions[] = {4, 16, 64};
  Errors errors[3];
  int touching = 0;
  for (int i = 0; i < kPairs; ++i) {
    const Vec3 aside = random.point(1.7);
    const PosedBodies bodies = {bumpy_ball(random, {}, 1), bumpy_ball(random, aside, 0.8)};
    const bool expected = !all_contacts(bodies, 0).empty();
    touching += expected;
    for (std::size_t r = 0; r < 3; ++r) {
      const bool seen = touch(bodies, kResolutions[r]);
      errors[r].missed += expected && !seen;
      errors[r].invented += !expected && seen;
    }
  }
  for (std::size_t r = 0; r < 3; ++r)
    std::printf("%u pixels: %d of %d missed, %d of %d invented\n", kResolutions[r],
                errors[r].missed, touching, errors[r].invented, kPairs - touching);
  EXPECT_GT(touching, kPairs / 4);
  EXPECT_LT(touching, kPairs * 9 / 10);
  EXPECT_GT(errors[0].missed, errors[2].missed);
  EXPECT_LE(errors[2].missed, touching / 20);
}

TEST(LayeredDepth, SaysNoOfSeparateBoxesAndYesOfDeepOverlaps) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Vec3 place = random.point(100), aside = random.point(0.3);
    const Vec3 near = {place.x + aside.x, place.y + aside.y, place.z + aside.z};
    const PosedBody ball = bumpy_ball(random, place, 1);
    EXPECT_TRUE(touch({ball, bumpy_ball(random, near, 1)}, 16));
    EXPECT_TRUE(touch({ball, bumpy_ball(random, near, 0.2)}, 16));  // wholly inside
    EXPECT_FALSE(touch({ball, bumpy_ball(random, {place.x, place.y + 2.1f, place.z}, 1)}, 64));
  }
}

TEST(LayeredDepth, HolesAreSurvived) {
  Random random(3);
  int seen = 0;
  for (int i = 0; i < 50; ++i) {
    PosedBodies bodies = {bumpy_ball(random, {}, 1), bumpy_ball(random, random.point(0.5), 1)};
    for (int hole = 0; hole < 10; ++hole)
      bodies.a.triangles.erase(bodies.a.triangles.begin() + random.index(200));
    seen += touch(bodies, 32);
  }
  EXPECT_GT(seen, 40);  // most rays still hit both sides of the ball
}

TEST(LayeredDepth, FlatAndHugeBodiesAreSurvived) {
  Random random(4);
  PosedBodies bodies = {bumpy_ball(random, {}, 1), bumpy_ball(random, {}, 1)};
  for (Vec3& p : bodies.a.frames[0]) p.y = 0.1f;
  EXPECT_FALSE(touch(bodies, 32) && all_contacts(bodies, 0).empty());
  for (Vec3& p : bodies.a.frames[0]) p = {0.1f, 0.1f, 0.1f};
  touch(bodies, 32);
  for (Vec3& p : bodies.a.frames[0]) p = random.point(0x1p59);
  touch(bodies, 32);
}

TEST(Rasteriser, CrossesClosedSurfacesEvenlyOften) {
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    PosedBody ball = bumpy_ball(random, {}, 1);
    if (i % 2)  // corners on pixel centres
      for (Vec3& p : ball.frames[0])
        p = {std::round(8 * p.x) / 8, std::round(8 * p.y) / 8, std::round(8 * p.z) / 8};
    const Box4 where = {Float4(-1.0625f), Float4(0.9375f)};
    const Rasteriser rasteriser(where, 16);
    std::vector<int> layers(16 * 16, 0);
    const Points points(ball.frames[0]);
    for (const Triangle& t : ball.triangles)
      rasteriser.draw({points[t[0]], points[t[1]], points[t[2]]},
                      [&](std::uint32_t pixel, float) { ++layers.at(pixel); });
    int covered = 0;
    for (const int count : layers) {
      ASSERT_EQ(count % 2, 0);
      covered += count > 0;
    }
    EXPECT_GT(covered, 50);
  }
}

}  // namespace
}  // namespace pelt::rivals
