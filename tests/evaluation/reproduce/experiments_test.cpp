/// Compares the figures that do not depend on the machine with the paper's.

#include "evaluation/reproduce/report.hpp"

#include <gtest/gtest.h>

#include <set>

namespace pelt::reproduce {
namespace {

double figure(const Table& table, std::size_t row, const std::string& key) {
  return table.rows[row][column_of(table, key)].figure.value();
}

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
    EXPECT_EQ(figure(table, row, "triangles"), figure(table, row, "paper_triangles"));
    EXPECT_EQ(figure(table, row, "joints"), figure(table, row, "paper_joints"));
  }
}

TEST(Tightness, OrdersTheColumnsAsThePaperDoes) {
  const Result<Section> section = tightness({});
  ASSERT_TRUE(section) << section.error().message;
  const Table& radii = section->tables[0];
  ASSERT_GE(radii.rows.size(), 8u);
  for (std::size_t row = 0; row < radii.rows.size(); ++row) {
    const double best = figure(radii, row, "best");
    for (const char* key : {"eq2", "on_demand", "exact_corners", "bottom_up"})
      EXPECT_GE(figure(radii, row, key), best) << key << " on level " << row + 1;
    EXPECT_LE(figure(radii, row, "exact_corners"), figure(radii, row, "on_demand"))
        << "on level " << row + 1;
    if (row >= 2) {
      EXPECT_LT(figure(radii, row, "on_demand"), figure(radii, row, "eq2"));
    }
  }
  const Table& boxes = section->tables[3];
  for (std::size_t row = 0; row < boxes.rows.size(); ++row)
    EXPECT_GE(figure(boxes, row, "ratio"), 1) << "on level " << row + 1;
}

}  // namespace
}  // namespace pelt::reproduce
