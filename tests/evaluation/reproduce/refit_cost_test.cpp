/// The parts of the experiment on refits. Times are not checked.

#include "evaluation/reproduce/refit_cost.hpp"
#include "evaluation/reproduce/characters.hpp"
#include "paper/counted_refit.hpp"
#include "paper/on_demand.hpp"
#include "scenes/creature.hpp"

#include <gtest/gtest.h>

namespace pelt::reproduce {
namespace {

const Conditions kQuick = {.is_quick = true, .models = {}};

double figure(const Table& table, std::size_t row, const std::string& key) {
  return table.rows[row][column_of(table, key)].figure.value();
}

TEST(RefitFlops, AreThoseOfTheFormula) {
  const Result<Table> table = flops_table();
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(figure(*table, row, "unexplained"), 0);
    const double joined = 2 * (figure(*table, row, "sets") - 1);
    EXPECT_GT(joined, 0);
    EXPECT_NEAR(figure(*table, row, "counted_flops"), figure(*table, row, "stated_flops") + joined,
                1e-6);
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
    EXPECT_NEAR(figure(*table, 2, key), figure(*table, 1, key) / figure(*table, 0, key), 1e-6);
}

TEST(Rebuild, HasARowForEachCharacter) {
  const Result<Table> table = rebuild_table(kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
}

}  // namespace
}  // namespace pelt::reproduce
