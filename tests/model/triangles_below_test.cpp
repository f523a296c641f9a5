#include "model/triangles_below.hpp"

#include "model/model.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pelt::detail {
namespace {

/// Appends the numbers of all triangles below a slot.
void append_below(const Tree& tree, const Node& node, unsigned slot,
                  std::vector<std::uint32_t>& numbers) {
  if (slot < node.cluster_count) {
    const Cluster& cluster = tree.clusters[node.first_cluster + slot];
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i)
      numbers.push_back(tree.triangle_ids[cluster.first_triangle + i]);
    return;
  }
  const Node& below = tree.nodes[node.first_child + slot - node.cluster_count];
  for (unsigned s = 0; s < unsigned{below.cluster_count} + below.child_count; ++s)
    append_below(tree, below, s, numbers);
}

TEST(TrianglesBelow, AreTheCountAndTheLowestNumberOfEachSlot) {
  const auto model = build_model(test::make_limb(60, 20, 5).view());
  const Tree& tree = model->detail().tree;
  ASSERT_GT(tree.nodes.size(), 10u);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    std::size_t below = 0;
    unsigned slot = 0;
    for (; slot < unsigned{node.cluster_count} + node.child_count; ++slot) {
      std::vector<std::uint32_t> numbers;
      append_below(tree, node, slot, numbers);
      EXPECT_EQ(triangles_below(tree, node, slot), numbers.size());
      EXPECT_EQ(tree.lowest_below[n][slot], *std::min_element(numbers.begin(), numbers.end()));
      below += numbers.size();
    }
    EXPECT_EQ(tree.triangles_below[n], below);
    for (; slot < kMaxSlots; ++slot) EXPECT_EQ(tree.lowest_below[n][slot], kNoTriangle);
  }
  EXPECT_EQ(tree.triangles_below[0], tree.triangle_count());
}

}  // namespace
}  // namespace pelt::detail
