#include "model/triangle_places.hpp"

#include "model/model.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

namespace pelt::detail {
namespace {

TEST(TrianglePlaces, FindNodeAndSlotOfEachTriangle) {
  const auto model = build_model(test::make_limb(60, 20, 5).view());
  const Tree& tree = model->detail().tree;
  ASSERT_GT(tree.nodes.size(), 10u);
  std::uint32_t found = 0;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t slot = 0; slot < tree.nodes[n].cluster_count; ++slot) {
      const Cluster& cluster = tree.clusters[tree.nodes[n].first_cluster + slot];
      for (std::uint32_t i = 0; i < cluster.triangle_count; ++i, ++found) {
        const std::uint32_t place = cluster.first_triangle + i;
        EXPECT_EQ(tree.triangle_places[tree.triangle_ids[place]], place);
        EXPECT_EQ(node_of_triangle(tree, place), n);
        EXPECT_EQ(slot_of_triangle(tree, tree.nodes[n], place), slot);
      }
    }
  EXPECT_EQ(found, tree.triangle_count());
}

}  // namespace
}  // namespace pelt::detail
