#include "scenes/creature/flesh.hpp"

#include "scenes/creature/body.hpp"
#include "scenes/creature/body_plan.hpp"
#include "scenes/creature/polygonise.hpp"
#include "scenes/creature/random.hpp"
#include "scenes/creature/skin_weights.hpp"
#include "scenes/creature/surface_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

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

std::map<std::string, double> named_weights(const BodyPlan& plan, const VertexWeights& vertex) {
  std::map<std::string, double> result;
  for (std::uint32_t k = 0; k < kInfluences; ++k) {
    if (vertex.weights[k] > 0) result[plan.joints[vertex.joints[k]].name] += vertex.weights[k];
  }
  return result;
}

class Skin : public testing::Test {
 protected:
  BodyPlan plan_ = make_body_plan(draw_proportions(1));
  std::vector<std::uint32_t> all_ = choose_joints(plan_, kPlanJoints);
  SkinWeights skin_{plan_, all_};
};

TEST_F(Skin, MiddleOfALimbFollowsItsJointAlone) {
  const Vec3d knee = plan_.joints[find_joint(plan_, "shin_l")].position;
  const Vec3d ankle = plan_.joints[find_joint(plan_, "foot_l")].position;
  Vec3d p = mix(knee, ankle, 0.5) + Vec3d(0.06, 0, 0);
  project_on_flesh(plan_.flesh, p);
  EXPECT_GT(named_weights(plan_, skin_.at(p))["shin_l"], 0.95);
}

TEST_F(Skin, KneeSharesThighAndShinAndNothingOfTheOtherLeg) {
  Vec3d p = plan_.joints[find_joint(plan_, "shin_l")].position + Vec3d(0, 0, 0.1);
  project_on_flesh(plan_.flesh, p);
  std::map<std::string, double> weights = named_weights(plan_, skin_.at(p));
  EXPECT_GT(weights["thigh_l"], 0.2);
  EXPECT_GT(weights["shin_l"], 0.2);
  for (const auto& [name, weight] : weights) EXPECT_EQ(name.find("_r"), std::string::npos) << name;
}

// Over the whole skin: weights of neighbours differ little, left and right never share a limb, and
// fingers never follow other fingers, only the hand.
TEST_F(Skin, WeightsAreSmoothAndLocal) {
  const double spacing = 0.016;
  const RawMesh mesh = polygonise(plan_.flesh, spacing);
  std::vector<std::map<std::string, double>> weights;
  std::set<std::string> used;
  for (const Vec3d& p : mesh.positions) {
    weights.push_back(named_weights(plan_, skin_.at(p)));
    double sum = 0;
    bool left = false, right = false;
    for (const auto& [name, weight] : weights.back()) {
      sum += weight;
      used.insert(name);
      left = left || (name == "shin_l" || name == "upper_arm_l");
      right = right || (name == "shin_r" || name == "upper_arm_r");
    }
    ASSERT_NEAR(sum, 1, 1e-12);
    ASSERT_FALSE(left && right);
  }
  EXPECT_EQ(used.size(), kPlanJoints);
  double steepest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto &a = weights[t[i]], &b = weights[t[(i + 1) % 3]];
      const double way = length(mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]);
      for (const auto& [name, weight] : a) {
        const auto other = b.find(name);
        const double step = std::abs(weight - (other == b.end() ? 0 : other->second));
        steepest = std::max(steepest, step / std::max(way, 0.25 * spacing));
      }
    }
  }
  EXPECT_LT(steepest, 200);  // at the clefts between the toes
  EXPECT_GT(steepest, 20);
}

TEST(Skeleton, EveryCountIsMetSymmetricallyAndNested) {
  const BodyPlan plan = make_body_plan({});
  for (std::uint32_t count = kBaseJoints; count <= kPlanJoints; ++count) {
    const std::vector<std::uint32_t> stands_for = choose_joints(plan, count);
    std::uint32_t kept = 0;
    for (std::uint32_t j = 0; j < kPlanJoints; ++j) {
      kept += stands_for[j] == j;
      EXPECT_EQ(stands_for[stands_for[j]], stands_for[j]);
      std::string name = plan.joints[j].name;
      if (name.size() < 2 || name.substr(name.size() - 2) != "_l") continue;
      name.back() = 'r';
      const std::uint32_t mirror = find_joint(plan, name);
      EXPECT_EQ(stands_for[j] == j, stands_for[mirror] == mirror) << count << " " << name;
    }
    EXPECT_EQ(kept, count);
  }
}

RawMesh ball() {
  Flesh flesh;
  flesh.limbs.push_back({{{0, {{0, 2, 0}, 1, {0, 2, 0}, 1}, 0.05, {}}}, 0.05, {}});
  compute_bounds(flesh);
  return polygonise(flesh, 0.25);
}

/// Whether every directed edge has its reverse and occurs once.
bool is_closed(const std::vector<Triangle>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      if (!edges.insert({t[i], t[(i + 1) % 3]}).second) return false;
    }
  }
  for (const auto& edge : edges) {
    if (edges.count({edge.second, edge.first}) == 0) return false;
  }
  return true;
}

std::size_t vertices_used(const std::vector<Triangle>& triangles) {
  std::set<std::uint32_t> vertices;
  for (const Triangle& t : triangles) vertices.insert(t.begin(), t.end());
  return vertices.size();
}

SurfaceMesh connect(const RawMesh& raw) {
  return {raw.triangles, static_cast<std::uint32_t>(raw.positions.size())};
}

TEST(Polygonise, BallIsClosedRoundAndFacesOutwards) {
  const RawMesh raw = ball();
  EXPECT_GT(raw.triangles.size(), 1000u);
  EXPECT_TRUE(is_closed(raw.triangles));
  EXPECT_EQ(2 * raw.positions.size(), raw.triangles.size() + 4);
  for (const Vec3d& p : raw.positions) EXPECT_NEAR(length(p - Vec3d(0, 2, 0)), 1, 0.06);
  for (const Triangle& t : raw.triangles) {
    const Vec3d &a = raw.positions[t[0]], &b = raw.positions[t[1]], &c = raw.positions[t[2]];
    EXPECT_GT(dot(cross(b - a, c - a), a + b + c - Vec3d(0, 6, 0)), 0);
  }
}

TEST(SurfaceMesh, RandomCollapsesAndFlipsKeepTheMeshClosed) {
  constexpr std::uint64_t kSeed = 11;
  SCOPED_TRACE(kSeed);
  SplitMix64 random(kSeed);
  const RawMesh raw = ball();
  SurfaceMesh mesh = connect(raw);
  int collapses = 0, flips = 0, refused = 0;
  for (int step = 0; step < 60000 && mesh.triangle_count() > 4; ++step) {
    const std::uint32_t h = static_cast<std::uint32_t>(random.next() % mesh.half_edge_count());
    if (!mesh.is_live_half_edge(h)) continue;
    if (step % 4 == 0 && mesh.can_collapse(h)) {
      mesh.collapse(h);
      ++collapses;
    } else if (step % 4 != 0 && mesh.can_flip(h)) {
      mesh.flip(h);
      ++flips;
    } else {
      ++refused;
    }
    if (step % 500 == 0) {
      const std::vector<Triangle> triangles = mesh.live_triangles();
      ASSERT_EQ(triangles.size(), mesh.triangle_count());
      ASSERT_TRUE(is_closed(triangles)) << step;
      ASSERT_EQ(2 * vertices_used(triangles), triangles.size() + 4) << step;
    }
  }
  EXPECT_GT(collapses, 400);
  EXPECT_GT(flips, 1000);
  EXPECT_GT(refused, 10);
  EXPECT_TRUE(is_closed(mesh.live_triangles()));
}

TEST(SurfaceMesh, TetrahedronRefusesAll) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const SurfaceMesh mesh(triangles, 4);
  for (std::uint32_t h = 0; h < 12; ++h) {
    EXPECT_FALSE(mesh.can_collapse(h));
    EXPECT_FALSE(mesh.can_flip(h));
  }
}

TEST(SurfaceMesh, FlipOfAnOctahedronsEdgeTwiceRestoresIt) {
  const std::vector<Triangle> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                           {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  SurfaceMesh mesh(triangles, 6);
  ASSERT_TRUE(is_closed(triangles));
  EXPECT_EQ(mesh.valence(4), 4u);
  ASSERT_TRUE(mesh.can_flip(0));
  mesh.flip(0);
  EXPECT_TRUE(is_closed(mesh.live_triangles()));
  EXPECT_EQ(mesh.valence(4), 5u);
  EXPECT_EQ(mesh.valence(0), 3u);
  mesh.flip(0);
  EXPECT_EQ(mesh.valence(4), 4u);
  EXPECT_EQ(mesh.valence(0), 4u);
}

}  // namespace
}  // namespace pelt::scenes
