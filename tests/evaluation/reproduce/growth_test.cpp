/// The parts of the experiment on growth, with small sizes. Times are not checked.

#include "evaluation/reproduce/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt::reproduce {
namespace {

const Conditions kQuick = {.is_quick = true, .models = {}};

double figure(const Table& table, std::size_t row, const std::string& key) {
  return table.rows[row][column_of(table, key)].figure.value();
}

TEST(Growth, OfTrianglesHasARowForEachSizeAllInContact) {
  constexpr std::array<std::uint32_t, 2> kSizes = {1000, 3000};
  const Result<Table> table = growth_by_triangles(kSizes, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_GT(figure(*table, 0, "contacts"), 0);
  EXPECT_GT(figure(*table, 1, "contacts"), figure(*table, 0, "contacts"));
}

TEST(Growth, OfDepthGoesFromNoContactToMany) {
  constexpr std::array<double, 3> kDistances = {1.2, 0.6, 0};
  const Result<Table> table = growth_by_depth(1000, kDistances, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 3u);
  EXPECT_EQ(figure(*table, 0, "contacts"), 0);
  EXPECT_GT(figure(*table, 1, "contacts"), 0);
  EXPECT_GT(figure(*table, 2, "contacts"), figure(*table, 1, "contacts"));
}

TEST(Growth, OfInstancesQueriesPairsOnlyInSmallCrowds) {
  constexpr std::array<std::uint32_t, 2> kInstances = {4, 20};
  const Result<Table> table = growth_by_instances(kInstances, 4, kQuick);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_GT(figure(*table, 1, "contacts"), 0);
  EXPECT_GT(figure(*table, 0, "paper_us"), 0);
  EXPECT_FALSE(table->rows[1][column_of(*table, "paper_us")].figure);
  EXPECT_GT(figure(*table, 1, "crowd_us"), 0);
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
  EXPECT_NEAR(figure(exponents, 0, "contacts"), 0.5, 1e-12);
  EXPECT_NEAR(figure(exponents, 0, "paper"), 2, 1e-12);
  EXPECT_NEAR(figure(exponents, 0, "on_demand"), 1, 1e-12);
  EXPECT_FALSE(exponents.rows[0][column_of(exponents, "crowd")].figure);
}

}  // namespace
}  // namespace pelt::reproduce
