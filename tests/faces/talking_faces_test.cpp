/// Every query of two generated, talking faces with changing morph weights, compared with all posed
/// triangles.

#include <pelt/pelt.hpp>

#include "base/hash.hpp"
#include "bounds/box_of_triangles.hpp"
#include "distance/brute_distance.hpp"
#include "ray/ray_oracle.hpp"
#include "scenes/creature.hpp"
#include "solid/region_oracle.hpp"
#include "support/instruction_sets.hpp"
#include "support/random.hpp"
#include "support/values.hpp"
#include "tools/pelt/methods/brute_force.hpp"

#include <bit>

namespace pelt::test {
namespace {

constexpr int kFrames = 8;

/// A face that plays its clip at a given position.
class Face {
 public:
  explicit Face(std::uint32_t seed)
      : asset_(*scenes::make_face({1000, seed})),
        pose(*build_model(asset_.mesh())),
        palette_(asset_.joints.size()),
        weights_(asset_.morph_targets.size()) {}

  void play(float seconds, const Matrix4& placement) {
    const asset::Clip* talk = asset_.find_clip("talk");
    asset::sample_palette(asset_, talk, seconds, placement, scratch_, palette_);
    asset::sample_morph_weights(asset_, talk, seconds, weights_);
    ASSERT_TRUE(pose.set_palette(palette_));
    ASSERT_TRUE(pose.set_morph_weights(weights_));
    positions = all_posed(pose);
  }

  const std::vector<Triangle>& triangles() const { return asset_.triangles; }

 private:
  asset::Asset asset_;

 public:
  Pose pose;
  std::vector<Vec3> positions;

 private:
  asset::SampleScratch scratch_;
  std::vector<Matrix4> palette_;
  std::vector<float> weights_;
};

/// Two faces opposite each other; their snouts intersect at first and separate later.
class TalkingFaces : public ::testing::Test {
 protected:
  void play(int frame) {
    const auto time = static_cast<float>(frame);
    a.play(0.47f * time, {});
    Matrix4 facing;  // half a turn about y
    facing.m[0] = facing.m[10] = -1;
    facing.m[14] = 0.5f + 0.04f * time;
    facing.m[13] = 0.02f;
    b.play(1.3f + 0.31f * time, facing);
  }

  std::vector<Contact> contacts() {
    std::vector<Contact> found;
    collide(a.pose, b.pose, scratch, found);
    return found;
  }

  Distance closest() {
    Distance found;
    distance(a.pose, b.pose, scratch, found);
    return found;
  }

  Face a{1}, b{2};
  Scratch scratch;
};

TEST_F(TalkingFaces, TouchWhereBruteForceSaysSo) {
  int touching = 0, apart = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    play(frame);
    std::vector<Contact> expected;
    methods::brute_force_collide(a.triangles(), a.positions, b.triangles(), b.positions, expected,
                                 UINT32_MAX);
    EXPECT_EQ(contacts(), expected) << frame;
    ++(expected.empty() ? apart : touching);
  }
  EXPECT_GE(touching, 2);
  EXPECT_GE(apart, 2);
}

TEST_F(TalkingFaces, AreAsFarApartAsBruteForceSays) {
  for (int frame = 0; frame < kFrames; frame += 2) {
    play(frame);
    const auto of_a = posed_triangles(a.triangles(), a.pose);
    const auto of_b = posed_triangles(b.triangles(), b.pose);
    const BruteDistance expected = brute_distance(of_a, of_b);
    EXPECT_EQ(closest().distance, expected.distance) << frame;
    EXPECT_EQ(closest().a.triangle, expected.triangle_a) << frame;
    std::vector<Contact> within;
    clearance(a.pose, b.pose, expected.distance + 0.01, scratch, within);
    EXPECT_EQ(within, brute_clearance(of_a, of_b, expected.distance + 0.01)) << frame;
    EXPECT_FALSE(within.empty());
  }
}

TEST_F(TalkingFaces, HaveExactBoxes) {
  for (int frame = 0; frame < kFrames; ++frame) {
    play(frame);
    const Bounds sure = test::bounds_of(a.pose), exact = test::exact_bounds_of(a.pose);
    EXPECT_TRUE(same_bits(exact.box, box_of(a.triangles(), a.positions))) << frame;
    EXPECT_TRUE(encloses(sure.box, exact.box)) << frame;
    EXPECT_TRUE(encloses(sure.sphere, a.triangles(), a.positions)) << frame;
    EXPECT_EQ(check_bounds(a.pose), "");
  }
}

TEST_F(TalkingFaces, AreHitWhereAllTrianglesAre) {
  Random random(61);
  std::size_t hits = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    play(frame);
    const RayOracle oracle(a.triangles(), a.pose);
    for (int i = 0; i < 40; ++i) {
      const Vec3& at = a.positions[random.index(static_cast<std::uint32_t>(a.positions.size()))];
      const Vec3 from = random.point(1);
      hits += expect_as_oracle(a.pose, oracle,
                               {from, {at.x - from.x, at.y - from.y, at.z - from.z}}, scratch) > 0;
    }
  }
  EXPECT_GT(hits, 250u);
}

TEST_F(TalkingFaces, AreInRegionsWhereAllTrianglesAre) {
  Random random(62);
  std::size_t touching = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    play(frame);
    for (int i = 0; i < 10; ++i) {
      const Vec3& at = a.positions[random.index(static_cast<std::uint32_t>(a.positions.size()))];
      const Region region = Sphere{at, random.uniformf(0.01, 0.2)};
      const TrianglesInRegion expected = brute_force(region, a.triangles(), a.positions);
      TrianglesInRegion found;
      find_triangles(a.pose, region, scratch, found);
      EXPECT_EQ(found.intersecting, expected.intersecting);
      EXPECT_EQ(found.inside, expected.inside);
      EXPECT_EQ(test::placement_of(a.pose, region, scratch),
                placement_of(expected, a.triangles().size()));
      touching += expected.intersecting.size();
    }
  }
  EXPECT_GT(touching, 1000u);
}

TEST_F(TalkingFaces, AreClosestWhereAllTrianglesAre) {
  Random random(63);
  for (int frame = 0; frame < kFrames; ++frame) {
    play(frame);
    const auto triangles = posed_triangles(a.triangles(), a.pose);
    for (int i = 0; i < 10; ++i) {
      const Vec3 point = random.point(0.6);
      double least = std::numeric_limits<double>::infinity();
      for (const TriangleCorners& triangle : triangles)
        least = std::min(
            least, detail::closest_on_triangle(detail::Vec3d(point), triangle).squared_distance);
      ClosestPoint found;
      closest_point(a.pose, point, scratch, found);
      EXPECT_EQ(found.distance, std::sqrt(least));
    }
  }
}

TEST_F(TalkingFaces, AreEnteredByTheVertexThatIsDeepest) {
  int entered = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    play(frame);
    double expected = 0;
    for (const Vec3& position : a.positions) {
      if (test::point_side(b.pose, position, scratch) != PointSide::inside) continue;
      ClosestPoint closest;
      closest_point(b.pose, position, scratch, closest);
      expected = std::max(expected, closest.distance);
    }
    Penetration deepest;
    deepest_vertex(a.pose, b.pose, scratch, deepest);
    EXPECT_EQ(deepest.depth, expected) << frame;
    entered += bool(deepest);
  }
  EXPECT_GE(entered, 2);
}

/// The answers of all frames.
class Answers {
 public:
  void add(float number) { hash_.add_u32(std::bit_cast<std::uint32_t>(number)); }
  void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
  void add(std::uint32_t number) { hash_.add_u32(number); }
  std::uint64_t value() const { return hash_.value(); }

 private:
  detail::Fnv1a64 hash_;
};

// The bits do not depend on the instruction set or the machine.
TEST_F(TalkingFaces, GiveTheSameBitsEverywhere) {
  on_each_instruction_set([&](InstructionSet) {
    Answers answers;
    QueryStats work;
    for (int frame = 0; frame < kFrames; ++frame) {
      play(frame);
      for (const Vec3& position : a.positions) answers.add(position);
      std::vector<Contact> found;
      work += collide(a.pose, b.pose, scratch, found);
      for (const Contact& contact : found) {
        answers.add(contact.triangle_a);
        answers.add(contact.triangle_b);
      }
      const Bounds sure = test::bounds_of(a.pose), exact = test::exact_bounds_of(b.pose);
      answers.add(sure.box.low), answers.add(sure.box.high), answers.add(sure.sphere.radius);
      answers.add(exact.box.low), answers.add(exact.box.high);
      const Distance near = closest();
      answers.add(near.a.position), answers.add(near.b.position);
      const RayHit hit = test::first_hit(b.pose, {{0, 0.25f, -1}, {0, 0, 1}});
      answers.add(hit.triangle), answers.add(hit.t), answers.add(hit.normal);
    }
    EXPECT_EQ(answers.value(), 0xcbb9944bf6d70b68u);
    EXPECT_GT(work.displacements, 1000u);
  });
}

}  // namespace
}  // namespace pelt::test
