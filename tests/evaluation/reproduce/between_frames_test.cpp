/// The section on queries between frames, with small characters. Times are not checked.

#include "evaluation/reproduce/between_frames.hpp"

#include <gtest/gtest.h>

namespace pelt::reproduce {
namespace {

const Conditions kQuickly = {.is_quick = true, .models = {}};

/// Two small creatures that walk through each other.
scenes::Scene walkers() {
  scenes::Scene scene;
  scene.name = "walkers";
  Result<scenes::Character> character = scenes::generate_character({1000, 24, 1});
  EXPECT_TRUE(character);
  scene.characters.push_back(std::move(*character));
  scene.fps = 12;
  scene.frame_count = 40;
  scene.instances.resize(2);
  for (const int i : {0, 1}) {
    scene.instances[i].clip = "walk";
    scene.instances[i].translation = {0.05 * i, 0, i == 0 ? -1.4 : 1.4};
    scene.instances[i].rotation = {0, double(i), 0, double(1 - i)};
    scene.instances[i].velocity = {0, 0, i == 0 ? 0.9 : -0.9};
  }
  return scene;
}

TEST(BetweenFrames, HasARowForEachQueryAndMethod) {
  const Result<Table> table = between_frames_table("walkers", "Walkers", walkers(), 80, kQuickly);
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

}  // namespace
}  // namespace pelt::reproduce
