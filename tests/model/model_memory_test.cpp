/// SkinnedModel::memory_bytes leaves no array out.

#include "model/model.hpp"

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

// The arrays that each_array visits: who adds one adds it there too.
static_assert(sizeof(detail::Tree) == 10 * sizeof(std::vector<int>) + 8);
static_assert(sizeof(detail::NodeBounds) == 5 * sizeof(std::vector<int>));

template <typename... Array>
std::size_t bytes_of(const Array&... arrays) {
  return ((arrays.size() * sizeof(arrays[0])) + ...);
}

TEST(ModelMemory, CountsEveryArrayAndHoldsLittleMore) {
  const auto model = build_model(test::make_limb(60, 40, 5).view());
  ASSERT_TRUE(model);
  const auto& [positions, begins, joints, weights, corners, ids, cluster_vertices, clusters, nodes,
               places, joint_count, extent] = model->detail().tree;
  const auto& bounds = model->detail().bounds;
  const std::size_t used =
      bytes_of(positions, begins, joints, weights, corners, ids, cluster_vertices, clusters, nodes,
               places) +
      bytes_of(bounds.nodes, bounds.joints, bounds.joint_boxes, bounds.shapes, bounds.fits);
  EXPECT_GT(used, 10 * model->triangle_count());
  EXPECT_GE(model->memory_bytes(), used);
  EXPECT_LE(model->memory_bytes(), used * 5 / 4);
  std::printf("%zu bytes used, %zu held, for %u triangles\n", used, model->memory_bytes(),
              model->triangle_count());
}

}  // namespace
}  // namespace pelt
