/// SkinnedModel::memory_bytes counts every array.

#include "model/model.hpp"

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

// The arrays that each_array visits, and those that are not in prepared files. If you add an array,
// add it there too.
static_assert(sizeof(detail::PoolMorphs) == 4 * sizeof(std::vector<int>));
static_assert(sizeof(detail::Tree) ==
              17 * sizeof(std::vector<int>) + sizeof(detail::PoolMorphs) + 16);
static_assert(sizeof(detail::NodeBounds) == 10 * sizeof(std::vector<int>));

template <typename... Array>
std::size_t bytes_of(const Array&... arrays) {
  return ((arrays.size() * sizeof(arrays[0])) + ...);
}

TEST(ModelMemory, CountsEveryArrayAndNeedsLittleMore) {
  test::Random random(335);
  test::Shape limb = test::make_limb(60, 40, 5);
  test::add_morph_targets(random, limb, 7, 0.3, 0.1);
  const auto model = build_model(limb.view());
  ASSERT_TRUE(model);
  const auto& [positions, begins, joints, weights, corners, ids, triangle_places, cluster_vertices,
               clusters, nodes, triangles_below, lowest_below, places, place_vertices, caps, welded,
               morphs, links, joint_count, extent, dual_influences] = model->detail().tree;
  const auto& bounds = model->detail().bounds;
  const std::size_t used =
      bytes_of(positions, begins, joints, weights, corners, ids, triangle_places, cluster_vertices,
               clusters, nodes, triangles_below, lowest_below, places, place_vertices, caps, welded,
               links) +
      bytes_of(morphs.extents, morphs.node_begin, morphs.targets, morphs.displacements) +
      bytes_of(bounds.nodes, bounds.joints, bounds.joint_boxes, bounds.shapes, bounds.fits,
               bounds.displacement_begin, bounds.displacements, bounds.dual_bounds,
               bounds.joint_pairs, bounds.offset_caps);
  EXPECT_GT(used, 10 * model->triangle_count());
  EXPECT_GE(model->memory_bytes(), used);
  EXPECT_LE(model->memory_bytes(), used * 5 / 4);
}

}  // namespace
}  // namespace pelt
