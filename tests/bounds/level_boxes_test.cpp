#include "bounds/level_boxes.hpp"

#include <pelt/collide.hpp>
#include <pelt/math.hpp>

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace pelt {
namespace {

using detail::BoxState;
using detail::LevelBoxes;
using detail::OpenedNode;
using test::Random;
using test::Shape;

Box box_at(const LevelBoxes& found, std::size_t i) {
  const float* b = &found.boxes[6 * i];
  return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
}

bool contains(const Box& box, const Vec3& p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y &&
         box.low.z <= p.z && p.z <= box.high.z;
}

/// A bending limb and another one across it.
class LevelBoxesTest : public ::testing::Test {
 protected:
  LevelBoxesTest() {
    Random random(700);
    EXPECT_TRUE(a.set_palette(test::bend_limb(random, 6, 0.4, {0, 0, 0})));
    EXPECT_TRUE(b.set_palette(test::bend_limb(random, 6, 0.3, {0.05f, 0, 0})));
  }

  /// The boxes of `a` at `level`.
  const LevelBoxes& at(std::uint32_t level) {
    copy_with_all_bounds(a.detail(), whole.detail());
    level_boxes(a.detail(), whole.detail(), level, found);
    EXPECT_EQ(found.boxes.size(), 6 * found.states.size());
    return found;
  }

  std::uint32_t levels() const { return level_count(model.detail().tree); }

  bool encloses(const LevelBoxes& boxes, const Vec3& p) const {
    for (std::size_t i = 0; i < boxes.states.size(); ++i)
      if (contains(box_at(boxes, i), p)) return true;
    return false;
  }

  Shape limb = test::make_limb(60, 20, 6);
  SkinnedModel model = *build_model(limb.view());
  Pose a{model}, b{model}, whole{model};
  LevelBoxes found;
};

TEST_F(LevelBoxesTest, EncloseTheSurfaceAtEachLevel) {
  std::vector<Vec3> vertices(model.vertex_count());
  posed_vertices(a, vertices);
  ASSERT_GT(levels(), 3u);
  std::size_t before = 0;
  for (std::uint32_t level = 0; level < levels(); ++level) {
    SCOPED_TRACE(level);
    const LevelBoxes& boxes = at(level);
    EXPECT_GT(boxes.states.size(), before);
    before = boxes.states.size();
    for (const Vec3& vertex : vertices) ASSERT_TRUE(encloses(boxes, vertex));
  }
  EXPECT_EQ(at(levels()).states.size(), before);
  EXPECT_EQ(at(0).states.size(), 1u);
}

TEST_F(LevelBoxesTest, ShowWhichNodesQueriesHaveOpened) {
  const auto has = [&](std::uint32_t level, BoxState state) {
    const std::vector<BoxState>& states = at(level).states;
    return std::find(states.begin(), states.end(), state) != states.end();
  };
  for (std::uint32_t level = 0; level < levels(); ++level) {
    EXPECT_FALSE(has(level, BoxState::opened));
    EXPECT_FALSE(has(level, BoxState::refitted));
  }
  EXPECT_EQ(opened_node_count(a.detail()), 0u);
  Scratch scratch;
  std::vector<Contact> contacts;
  const QueryStats work = collide(a, b, scratch, contacts);
  ASSERT_FALSE(contacts.empty());
  const std::uint32_t opened = opened_node_count(a.detail());
  EXPECT_GT(opened, 0u);
  EXPECT_LE(opened + opened_node_count(b.detail()), work.refits);
  EXPECT_EQ(at(0).states[0], BoxState::opened);
  EXPECT_TRUE(has(levels() - 1, BoxState::opened));
  EXPECT_TRUE(has(levels() - 1, BoxState::refitted));
  EXPECT_EQ(opened_node_count(a.detail()), opened) << "looking must open nothing";
}

TEST_F(LevelBoxesTest, OfTheWholeAreThoseThatQueriesRefit) {
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  copy_with_all_bounds(a.detail(), whole.detail());
  std::uint32_t compared = 0;
  for (std::uint32_t n = 0; n < model.detail().tree.nodes.size(); ++n) {
    const OpenedNode* mine = a.detail().opened[n];
    if (mine == nullptr) continue;
    const OpenedNode& theirs = *whole.detail().opened[n];
    EXPECT_EQ(std::memcmp(mine->low, theirs.low, sizeof(mine->low)), 0);
    EXPECT_EQ(std::memcmp(mine->high, theirs.high, sizeof(mine->high)), 0);
    ++compared;
  }
  EXPECT_GT(compared, 0u);
  EXPECT_EQ(compared, opened_node_count(a.detail()));
}

}  // namespace
}  // namespace pelt
