/// Opening nodes gives the same bits and the same work on every instruction set.

#include "pose/open_node.hpp"
#include "model/unpack.hpp"
#include "pose/pose.hpp"
#include "pose/pose_boxes.hpp"
#include "skin/skin.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pelt {
namespace {

using detail::kMaxSlots;
using detail::Node;
using detail::OpenedNode;
using detail::Tree;
using test::Motion;
using test::Random;
using test::Weights;

using Bits = std::vector<std::uint32_t>;
using Box = std::array<std::array<float, 3>, 2>;  // lowest and highest corner

void append(Bits& bits, const float* floats, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bits.push_back(std::bit_cast<std::uint32_t>(floats[i]));
}

template <std::size_t kCount>
void append(Bits& bits, const float (&rows)[3][kCount]) {
  for (const auto& row : rows) append(bits, row, kCount);
}

/// All data of a pose's opened nodes, bit by bit, without the unused fourth lanes.
Bits bits_of(Pose& pose) {
  const Tree& tree = pose.model().detail().tree;
  Bits bits;
  const detail::RootBox& root = pose.detail().root_box;
  if (root.known) append(bits, root.low, 3), append(bits, root.high, 3);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const OpenedNode* opened = pose.detail().opened[n];
    if (!opened) continue;
    bits.push_back(n);
    append(bits, opened->low), append(bits, opened->high);
    append(bits, opened->all_low, 3), append(bits, opened->all_high, 3);
    for (std::uint32_t v = 0; v < tree.nodes[n].vertex_count; ++v)
      append(bits, opened->positions + 4 * v, 3);
    for (std::uint32_t slot = 0; slot < tree.nodes[n].cluster_count; ++slot)
      if (const detail::TriangleBoxes* boxes = opened->triangles[slot].load())
        append(bits, boxes->low), append(bits, boxes->high);
  }
  return bits;
}

/// Soups and limbs in all kinds of poses.
template <typename Body>
void for_all_poses(Random& random, const Body& body) {
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (const std::uint32_t influences : {1u, 2u, 3u, 4u, 5u, 12u}) {
      const test::Shape soup = test::make_soup(random, 250, 20, influences, Weights::adversarial);
      body(Pose(*build_model(soup.view())), test::make_palette(random, 20, motion, 2));
    }
  const Pose limb(*build_model(test::make_limb(60, 20, 5).view()));
  body(Pose(limb.model()), test::bend_limb(random, 5, 0.3, {1, 2, 3}));
}

using Opening = QueryStats (*)(const detail::PosedTree&);

QueryStats compute_all_bounds_anew(const detail::PosedTree& posed) {
  make_table(posed);
  return detail::compute_all_bounds(posed);
}

QueryStats open_all_anew(const detail::PosedTree& posed) {
  make_table(posed);
  return detail::open_all(posed);
}

TEST(OpenNode, AllInstructionSetsGiveTheSameBitsByTheSameWork) {
  Random random(70);
  for_all_poses(random, [](Pose pose, const std::vector<Matrix4>& palette) {
    for (const Opening open : {compute_all_bounds_anew, open_all_anew}) {
      Bits expected;
      QueryStats expected_work;
      test::on_each_instruction_set([&](InstructionSet set) {
        ASSERT_TRUE(pose.set_palette(palette));
        const QueryStats work = open(pose.detail().posed_tree());
        if (set == available_instruction_sets().front()) {
          expected = bits_of(pose);
          expected_work = work;
        }
        ASSERT_EQ(bits_of(pose), expected);
        EXPECT_EQ(work.refits, expected_work.refits);
        EXPECT_EQ(work.posed_vertices, expected_work.posed_vertices);
      });
      EXPECT_GT(expected.size(), 1000u);
    }
  });
}

TEST(OpenNode, PoolsHaveTheBitsOfTheDefinition) {
  Random random(71);
  std::size_t compared = 0;
  for_all_poses(random, [&](Pose pose, const std::vector<Matrix4>& palette) {
    const Tree& tree = pose.model().detail().tree;
    const detail::SkinnedMesh vertices = unpack_vertices(tree);
    test::on_each_instruction_set([&](InstructionSet) {
      ASSERT_TRUE(pose.set_palette(palette));
      compute_all_bounds_anew(pose.detail().posed_tree());
      for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
        const Node& node = tree.nodes[n];
        for (std::uint32_t v = 0; v < node.vertex_count; ++v, ++compared) {
          const Vec3 p =
              scalar::posed_vertex(vertices, pose.detail().palette, node.first_vertex + v);
          const float* posed = pose.detail().opened[n]->positions + 4 * v;
          Bits expected, found;
          append(expected, &p.x, 3), append(found, posed, 3);
          ASSERT_EQ(found, expected) << "vertex " << v << " of node " << n;
        }
      }
    });
  });
  EXPECT_GT(compared, 15'000 * available_instruction_sets().size());
}

TEST(OpenNode, AReservedPoseHasRoomForAllNodesAndNoMore) {
  Random random(74);
  std::size_t bytes = 0;
  for_all_poses(random, [&](Pose pose, const std::vector<Matrix4>& palette) {
    const std::vector<Vec3> vertices(pose.model().vertex_count());
    test::on_each_instruction_set([&](InstructionSet) {
      pose.reserve();
      const detail::Arena& arena = pose.detail().arena;
      const std::size_t reserved = arena.capacity();
      std::size_t most = 0;
      for (int round = 0; round < 4; ++round) {
        ASSERT_TRUE(round % 2 == 0 ? pose.set_palette(palette) : pose.set_vertices(vertices));
        compute_all_bounds_anew(pose.detail().posed_tree());
        most = std::max(most, arena.used());
        EXPECT_EQ(arena.capacity(), reserved);
      }
      EXPECT_EQ(most, reserved);
      bytes += reserved;
    });
  });
  EXPECT_GT(bytes, 100'000u);
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Box kEmpty = {{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}}};

void include(Box& box, const Box& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    box[0][a] = std::min(box[0][a], other[0][a]);
    box[1][a] = std::max(box[1][a], other[1][a]);
  }
}

template <std::size_t kCount>
Box lane(const float (&low)[3][kCount], const float (&high)[3][kCount], std::size_t i) {
  return {{{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}}};
}

/// The box of a triangle in an opened node.
Box triangle_box(const Tree& tree, const OpenedNode& opened, std::uint32_t triangle) {
  Box box = kEmpty;
  for (const std::uint16_t corner : tree.corners[triangle]) {
    const float* p = opened.positions + corner;
    include(box, {{{p[0], p[1], p[2]}, {p[0], p[1], p[2]}}});
  }
  return box;
}

Box cluster_box(const Tree& tree, const OpenedNode& opened, std::uint32_t cluster) {
  Box box = kEmpty;
  for (std::uint32_t i = 0; i < tree.clusters[cluster].triangle_count; ++i)
    include(box, triangle_box(tree, opened, tree.clusters[cluster].first_triangle + i));
  return box;
}

TEST(OpenNode, BoxesOfClustersAndTrianglesAreExactAndFreeSlotsEmpty) {
  Random random(72);
  std::size_t free_slots = 0, triangles = 0;
  for_all_poses(random, [&](Pose pose, const std::vector<Matrix4>& palette) {
    const Tree& tree = pose.model().detail().tree;
    ASSERT_TRUE(pose.set_palette(palette));
    compute_all_bounds_anew(pose.detail().posed_tree());
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
      const Node& node = tree.nodes[n];
      const OpenedNode& opened = *pose.detail().opened[n];
      Box all = kEmpty;
      for (std::uint32_t slot = 0; slot < kMaxSlots; ++slot) {
        const Box box = lane(opened.low, opened.high, slot);
        if (slot >= node.cluster_count + node.child_count) {
          ASSERT_EQ(box, kEmpty);
          ++free_slots;
          continue;
        }
        include(all, box);
        if (slot >= node.cluster_count) continue;
        const detail::Cluster& cluster = tree.clusters[node.first_cluster + slot];
        ASSERT_EQ(box, cluster_box(tree, opened, node.first_cluster + slot));
        const detail::TriangleBoxes& boxes = *opened.triangles[slot].load();
        for (std::uint32_t i = 0; i < detail::kMaxClusterTriangles; ++i, ++triangles)
          ASSERT_EQ(
              lane(boxes.low, boxes.high, i),
              triangle_box(tree, opened,
                           cluster.first_triangle + std::min(i, cluster.triangle_count - 1u)));
      }
      for (std::size_t a = 0; a < 3; ++a) {
        ASSERT_EQ(opened.all_low[a], all[0][a]);
        ASSERT_EQ(opened.all_high[a], all[1][a]);
      }
    }
  });
  EXPECT_GT(free_slots, 50u);
  EXPECT_GT(triangles, 5'000u);
}

TEST(OpenNode, OpenedExactlyEveryBoxIsTheSmallest) {
  Random random(73);
  std::size_t children = 0;
  for_all_poses(random, [&](Pose pose, const std::vector<Matrix4>& palette) {
    const Tree& tree = pose.model().detail().tree;
    ASSERT_TRUE(pose.set_palette(palette));
    const QueryStats work = open_all_anew(pose.detail().posed_tree());
    EXPECT_EQ(work.refits, tree.clusters.size() + tree.nodes.size() - 1);
    std::vector<Box> below(tree.nodes.size(), kEmpty);
    for (std::size_t n = tree.nodes.size(); n-- > 0;) {
      const Node& node = tree.nodes[n];
      const OpenedNode& opened = *pose.detail().opened[static_cast<std::uint32_t>(n)];
      for (std::uint32_t c = 0; c < node.cluster_count; ++c)
        include(below[n], cluster_box(tree, opened, node.first_cluster + c));
      for (std::uint32_t c = 0; c < node.child_count; ++c, ++children) {
        ASSERT_EQ(lane(opened.low, opened.high, node.cluster_count + c),
                  below[node.first_child + c]);
        include(below[n], below[node.first_child + c]);
      }
    }
  });
  EXPECT_GT(children, 30u);
}

}  // namespace
}  // namespace pelt
