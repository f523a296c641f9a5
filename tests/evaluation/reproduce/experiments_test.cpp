/// Compares the figures that do not depend on the machine with the paper's.

#include <pelt/model.hpp>

#include "evaluation/reproduce/between_frames.hpp"
#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/growth.hpp"
#include "evaluation/reproduce/refit_cost.hpp"
#include "evaluation/reproduce/report.hpp"
#include "evaluation/reproduce/self_collision.hpp"
#include "evaluation/reproduce/subdivision.hpp"
#include "evaluation/two_walkers.hpp"
#include "paper/counted_refit.hpp"
#include "paper/on_demand.hpp"
#include "scenes/creature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace pelt::reproduce {
namespace {

const Conditions kQuick = {.is_quick = true, .models = {}};

TEST(Experiments, HaveIdsOfTheirOwn) {
  std::set<std::string> ids;
  for (const Experiment& experiment : experiments())
    EXPECT_TRUE(ids.insert(experiment.id).second) << experiment.id;
}

TEST(Characters, HaveThePapersSizes) {
  const Result<Section> section = characters({});
  ASSERT_TRUE(section) << section.error().message;
  const Table& table = section->tables[0];
  ASSERT_EQ(table.rows.size(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(figure_at(table, row, "triangles"), figure_at(table, row, "paper_triangles"));
    EXPECT_EQ(figure_at(table, row, "joints"), figure_at(table, row, "paper_joints"));
  }
}

TEST(Tightness, OrdersTheColumnsAsThePaperDoes) {
  const Result<Section> section = tightness({});
  ASSERT_TRUE(section) << section.error().message;
  const Table& radii = section->tables[0];
  ASSERT_GE(radii.rows.size(), 8u);
  for (std::size_t row = 0; row < radii.rows.size(); ++row) {
    const double best = figure_at(radii, row, "best");
    for (const char* key : {"eq2", "on_demand", "exact_corners", "bottom_up"})
      EXPECT_GE(figure_at(radii, row, key), best) << key << " on level " << row + 1;
    EXPECT_LE(figure_at(radii, row, "exact_corners"), figure_at(radii, row, "on_demand"))
        << "on level " << row + 1;
    if (row >= 2) {
      EXPECT_LT(figure_at(radii, row, "on_demand"), figure_at(radii, row, "eq2"));
    }
  }
  const Table& boxes = section->tables[3];
  for (std::size_t row = 0; row < boxes.rows.size(); ++row)
    EXPECT_GE(figure_at(boxes, row, "ratio"), 1) << "on level " << row + 1;
}

// The section on queries between frames, with small characters. Times are not checked.

TEST(BetweenFrames, HasARowForEachQueryAndMethod) {
  const Result<Table> table =
      between_frames_table("walkers", "Walkers", test::two_walkers(), 80, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 14u) << "five queries and three methods; united finds no first";
  for (const std::vector<Cell>& row : table->rows) {
    ASSERT_EQ(row.size(), table->columns.size());
    for (const char* key : {"mean_us", "median_us", "contact_us", "of_collide", "of_on_demand"})
      EXPECT_GT(row[column_of(*table, key)].figure.value(), 0) << key;
    const bool is_discrete = row[0].name == "collide";
    EXPECT_EQ(row[column_of(*table, "float")].figure.has_value(), !is_discrete);
  }
}

// The parts of the experiment on growth, with small sizes. Times are not checked.

TEST(Growth, OfTrianglesHasARowForEachSizeAllInContact) {
  constexpr std::array<std::uint32_t, 2> kSizes = {1000, 3000};
  const Result<Table> table = growth_by_triangles(kSizes, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_GT(figure_at(*table, 0, "contacts"), 0);
  EXPECT_GT(figure_at(*table, 1, "contacts"), figure_at(*table, 0, "contacts"));
}

TEST(Growth, OfDepthGoesFromNoContactToMany) {
  constexpr std::array<double, 3> kDistances = {1.2, 0.6, 0};
  const Result<Table> table = growth_by_depth(1000, kDistances, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
  EXPECT_EQ(figure_at(*table, 0, "contacts"), 0);
  EXPECT_GT(figure_at(*table, 1, "contacts"), 0);
  EXPECT_GT(figure_at(*table, 2, "contacts"), figure_at(*table, 1, "contacts"));
}

TEST(Growth, OfInstancesQueriesPairsOnlyInSmallCrowds) {
  constexpr std::array<std::uint32_t, 2> kInstances = {4, 20};
  const Result<Table> table = growth_by_instances(kInstances, 4, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_GT(figure_at(*table, 1, "contacts"), 0);
  EXPECT_GT(figure_at(*table, 0, "paper_us"), 0);
  EXPECT_FALSE(table->rows[1][column_of(*table, "paper_us")].figure);
  EXPECT_GT(figure_at(*table, 1, "crowd_us"), 0);
}

TEST(Growth, ExponentsAreTakenOverTheSizesThatWereMeasured) {
  Table table = {"t", "", {{"triangles", ""}, {"contacts", ""}}, {}, ""};
  for (const std::size_t method : {0, 3}) table.columns.push_back(kGrowingMethods[method].column());
  for (const double size : {100.0, 400.0, 900.0})
    table.rows.push_back({size, std::sqrt(size), size * size, 7 * size});
  table.rows.push_back({1600.0, 40.0, Cell(), 7 * 1600.0});
  table.rows.push_back({2.0, 0.0, 5000.0, 5000.0});  // no contacts: left out
  const std::array growths = {Growth{"triangles", table}};
  const Table exponents = exponents_of(growths);
  ASSERT_EQ(exponents.rows.size(), 1u);
  EXPECT_NEAR(figure_at(exponents, 0, "contacts"), 0.5, 1e-12);
  EXPECT_NEAR(figure_at(exponents, 0, "paper"), 2, 1e-12);
  EXPECT_NEAR(figure_at(exponents, 0, "on_demand"), 1, 1e-12);
  EXPECT_FALSE(exponents.rows[0][column_of(exponents, "crowd")].figure);
}

std::vector<Measured> power(double factor, double exponent) {
  std::vector<Measured> points;
  for (const double size : {1.0, 3.0, 10.0, 250.0, 1e6})
    points.push_back({size, factor * std::pow(size, exponent)});
  return points;
}

TEST(FittedExponent, IsThatOfAnExactPower) {
  for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.25})
    for (const double factor : {1e-3, 1.0, 700.0})
      EXPECT_NEAR(fitted_exponent(power(factor, exponent)), exponent, 1e-12);
}

TEST(FittedExponent, LeavesOutPointsWithoutALogarithm) {
  std::vector<Measured> points = power(2, 0.5);
  points.push_back({0, 5});
  points.push_back({7, 0});
  EXPECT_NEAR(fitted_exponent(points), 0.5, 1e-12);
}

/// By hand: logarithms (0, 0), (1, 1), (2, 1) have the slope 1/2.
TEST(FittedExponent, IsTheLeastSquaresSlope) {
  const std::vector<Measured> points = {
      {1, 1}, {std::exp(1), std::exp(1)}, {std::exp(2), std::exp(1)}};
  EXPECT_NEAR(fitted_exponent(points), 0.5, 1e-12);
}

// The parts of the experiment on refits. Times are not checked.

TEST(RefitFlops, AreThoseOfTheFormula) {
  const Result<Table> table = flops_table();
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(figure_at(*table, row, "unexplained"), 0);
    const double joined = 2 * (figure_at(*table, row, "sets") - 1);
    EXPECT_GT(joined, 0);
    EXPECT_NEAR(figure_at(*table, row, "counted_flops"),
                figure_at(*table, row, "stated_flops") + joined, 1e-6);
  }
}

TEST(RefitFacts, AreThoseOfEveryNode) {
  const Specimen dwarf = *make_specimen(scenes::kDwarf);
  const paper::SphereModel model = paper::build_sphere_model(dwarf.mesh);
  const std::vector<NodeFacts> facts = facts_of(model, dwarf.mesh);
  ASSERT_EQ(facts.size(), model.tree.nodes.size());
  EXPECT_EQ(facts[0].vertices, dwarf.mesh.vertex_count());
  for (std::uint32_t n = 0; n < facts.size(); ++n) {
    EXPECT_EQ(facts[n].flops, paper::stated_flops(model.bounds.sets_of(n)).total());
    if (model.tree.nodes[n].is_leaf()) {
      EXPECT_EQ(facts[n].vertices, 3);
    }
  }
}

TEST(RefitClasses, HaveNodesThatAreMuchTheSame) {
  const Specimen dwarf = *make_specimen(scenes::kDwarf);
  const paper::SphereModel model = paper::build_sphere_model(dwarf.mesh);
  const std::vector<NodeFacts> facts = facts_of(model, dwarf.mesh);
  const std::vector<NodeClass> classes =
      time_classes(model, walking_palette(dwarf, 0.3f), facts, &NodeFacts::joints, 1);
  ASSERT_GE(classes.size(), 4u);
  EXPECT_EQ(classes[0].facts.joints, 1);
  double nodes = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    nodes += classes[i].nodes;
    EXPECT_GT(classes[i].nanoseconds, 0);
    if (i > 0) {
      EXPECT_GT(classes[i].facts.joints, classes[i - 1].facts.joints);
    }
  }
  EXPECT_LT(nodes, static_cast<double>(facts.size()));
  EXPECT_GT(nodes, 0.9 * static_cast<double>(facts.size()));
}

TEST(OneJointSet, GivesEveryNodeTwoJointsAndTwoCorners) {
  const Specimen dwarf = *make_specimen(scenes::kDwarf);
  const detail::SkinnedMesh mesh = with_one_joint_set(dwarf.mesh);
  const paper::SphereModel model = paper::build_sphere_model(mesh);
  for (const NodeFacts& facts : facts_of(model, mesh)) {
    EXPECT_EQ(facts.joints, 2);
    EXPECT_EQ(facts.corners, 2);
  }
}

TEST(AllSpheres, AreListedBesideTheSpheresOfThePaper) {
  const Result<Table> table = all_spheres_table(kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
  for (const char* key : {"on_demand_ms", "bottom_up_ms", "ratio"})
    EXPECT_NEAR(figure_at(*table, 2, key), figure_at(*table, 1, key) / figure_at(*table, 0, key),
                1e-6);
}

TEST(Rebuild, HasARowForEachCharacter) {
  const Result<Table> table = rebuild_table(kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
}

// The section on self-collision, with small characters. Times are not checked.

TEST(SelfCollision, GrowthHasARowForEachSize) {
  constexpr std::array<std::uint32_t, 2> kSizes = {3000, 13590};
  const Result<Table> table = self_growth(kSizes, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(figure_at(*table, row, "triangles"), kSizes[row]);
    for (const char* key : {"boxes_us", "self_us", "first_us", "of_boxes", "filter_ms"})
      EXPECT_GT(figure_at(*table, row, key), 0) << key;
    EXPECT_GT(figure_at(*table, row, "filter_bytes"), 20);
    EXPECT_LT(figure_at(*table, row, "filter_bytes"), 60);
  }
  EXPECT_GT(figure_at(*table, 1, "contacts"), 0) << "of the creature of the paper's size";
  EXPECT_GT(figure_at(*table, 1, "node_pairs"), figure_at(*table, 0, "node_pairs"));
  EXPECT_GT(figure_at(*table, 1, "triangle_pairs"), figure_at(*table, 0, "triangle_pairs"));
}

TEST(SelfCollision, ExponentsAreThoseOfTheColumns) {
  Table growth = {"self_growth", "", {{"triangles", ""}}, {}, ""};
  for (const char* key : {"contacts", "boxes_us", "self_us", "first_us"})
    growth.columns.push_back({key, ""});
  for (const double size : {100.0, 400.0, 900.0})
    growth.rows.push_back({size, 0.0, 3 * size, size * size, std::sqrt(size)});
  const Table exponents = self_exponents(growth);
  ASSERT_EQ(exponents.rows.size(), 1u);
  EXPECT_FALSE(exponents.rows[0][column_of(exponents, "contacts")].figure);
  EXPECT_NEAR(figure_at(exponents, 0, "boxes_us"), 1, 1e-12);
  EXPECT_NEAR(figure_at(exponents, 0, "self_us"), 2, 1e-12);
  EXPECT_NEAR(figure_at(exponents, 0, "first_us"), 0.5, 1e-12);
}

TEST(SelfCollision, StagesAreSharesOfTheWhole) {
  const auto character = scenes::generate_character(scenes::kDwarf);
  ASSERT_TRUE(character);
  const Result<Table> table = self_stage_table(std::span(&*character, 1), kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 1u);
  double sum = 0;
  for (const char* key : {"open", "triangle_boxes", "descent", "fans", "cluster_pairs"})
    sum += figure_at(*table, 0, key);
  EXPECT_NEAR(sum, 100, 1e-6);
  for (const char* key : {"all_us", "open", "triangle_boxes", "descent"})
    EXPECT_GT(figure_at(*table, 0, key), 0) << key;
}

TEST(SelfCollision, WalksTheWholeClip) {
  const auto character = scenes::generate_character(scenes::kDwarf);
  ASSERT_TRUE(character);
  const scenes::Scene scene = lone_walker(*character);
  EXPECT_EQ(scene.instances[0].clip, "walk");
  EXPECT_GT(scene.frame_count, 20u);
}

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
