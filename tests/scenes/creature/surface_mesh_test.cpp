#include "scenes/creature/surface_mesh.hpp"

#include "scenes/creature/polygonise.hpp"
#include "scenes/creature/random.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace pelt::scenes {
namespace {

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
