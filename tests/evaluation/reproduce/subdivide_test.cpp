#include "evaluation/reproduce/subdivision.hpp"

#include <pelt/model.hpp>

#include "scenes/creature.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace pelt::reproduce {
namespace {

asset::Asset dwarf() { return *scenes::make_creature(scenes::kDwarf); }

TEST(Subdivided, CutsEachTriangleIntoFourWithSharedMiddles) {
  const asset::Asset coarse = dwarf(), fine = subdivided(coarse);
  EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
  // A closed surface has three edges per two triangles.
  EXPECT_EQ(fine.rest_positions.size(),
            coarse.rest_positions.size() + coarse.triangles.size() * 3 / 2);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : fine.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_TRUE(edges.insert({t[i], t[(i + 1) % 3]}).second) << "turned over, or twice";
  for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u) << "a hole";
}

TEST(Subdivided, GivesNewVerticesWeightsThatSumToOne) {
  const asset::Asset fine = subdivided(subdivided(dwarf()));
  const std::size_t slots = fine.influences_per_vertex;
  EXPECT_GT(slots, 4u);
  for (std::size_t v = 0; v < fine.rest_positions.size(); ++v) {
    const float* first = &fine.weights[slots * v];
    EXPECT_NEAR(std::accumulate(first, first + slots, 0.0f), 1, 1e-5);
  }
  EXPECT_TRUE(build_model(fine.mesh()));
}

TEST(DriftOf, IsNoneWhereAllJointsMoveAlikeAndSomeElsewhere) {
  const asset::Asset coarse = dwarf(), fine = subdivided(coarse);
  Matrix4 moved;
  moved.m[12] = 3;
  std::vector<Matrix4> palette(coarse.joints.size(), moved);
  EXPECT_LT(drift_of(coarse, fine, palette), 1e-6);
  asset::SampleScratch scratch;
  asset::sample_palette(coarse, coarse.find_clip("walk"), 0.2f, {}, scratch, palette);
  EXPECT_GT(drift_of(coarse, fine, palette), 1e-4);
}

}  // namespace
}  // namespace pelt::reproduce
