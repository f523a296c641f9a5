/// The section on self-collision, with small characters. Times are not checked.

#include "evaluation/reproduce/self_collision.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt::reproduce {
namespace {

const Conditions kQuickly = {.is_quick = true, .models = {}};

double cell(const Table& table, std::size_t row, const std::string& key) {
  return table.rows[row][column_of(table, key)].figure.value();
}

TEST(SelfCollision, GrowthHasARowForEachSize) {
  constexpr std::array<std::uint32_t, 2> kSizes = {3000, 13590};
  const Result<Table> table = self_growth(kSizes, kQuickly);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(cell(*table, row, "triangles"), kSizes[row]);
    for (const char* key : {"boxes_us", "self_us", "first_us", "of_boxes", "filter_ms"})
      EXPECT_GT(cell(*table, row, key), 0) << key;
    EXPECT_GT(cell(*table, row, "filter_bytes"), 20);
    EXPECT_LT(cell(*table, row, "filter_bytes"), 60);
  }
  EXPECT_GT(cell(*table, 1, "contacts"), 0) << "of the creature of the paper's size";
  EXPECT_GT(cell(*table, 1, "node_pairs"), cell(*table, 0, "node_pairs"));
  EXPECT_GT(cell(*table, 1, "triangle_pairs"), cell(*table, 0, "triangle_pairs"));
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
  EXPECT_NEAR(cell(exponents, 0, "boxes_us"), 1, 1e-12);
  EXPECT_NEAR(cell(exponents, 0, "self_us"), 2, 1e-12);
  EXPECT_NEAR(cell(exponents, 0, "first_us"), 0.5, 1e-12);
}

TEST(SelfCollision, StagesAreSharesOfTheWhole) {
  const auto character = scenes::generate_character(scenes::kDwarf);
  ASSERT_TRUE(character);
  const Result<Table> table = self_stage_table(std::span(&*character, 1), kQuickly);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->rows.size(), 1u);
  double sum = 0;
  for (const char* key : {"open", "triangle_boxes", "descent", "fans", "cluster_pairs"})
    sum += cell(*table, 0, key);
  EXPECT_NEAR(sum, 100, 1e-6);
  for (const char* key : {"all_us", "open", "triangle_boxes", "descent"})
    EXPECT_GT(cell(*table, 0, key), 0) << key;
}

TEST(SelfCollision, WalksTheWholeClip) {
  const auto character = scenes::generate_character(scenes::kDwarf);
  ASSERT_TRUE(character);
  const scenes::Scene scene = lone_walker(*character);
  EXPECT_EQ(scene.instances[0].clip, "walk");
  EXPECT_GT(scene.frame_count, 20u);
}

}  // namespace
}  // namespace pelt::reproduce
