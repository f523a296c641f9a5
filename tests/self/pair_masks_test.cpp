#include "self/pair_masks.hpp"
#include "model/model.hpp"
#include "self/self_brute_force.hpp"
#include "self/surface_shapes.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {
namespace {

using detail::PairMask;
using detail::PairMasks;

struct Masked {
  explicit Masked(const Shape& s)
      : shape(s),
        model(*build_model(shape.view())),
        tree(model.detail().tree),
        fans(tree),
        masks(tree, fans) {}

  Shape shape;
  SkinnedModel model;
  const detail::Tree& tree;
  detail::Fans fans;
  PairMasks masks;
};

/// The mask that is kept for two clusters, or null.
const PairMask* find_mask(const Masked& masked, std::uint32_t low, std::uint32_t high) {
  const PairMasks& masks = masked.masks;
  for (std::uint32_t i = masks.begin[low]; i < masks.begin[low + 1]; ++i)
    if (masks.others[i] == high) return &masks.masks[i];
  return nullptr;
}

/// The mask that a query applies to two clusters.
PairMask mask_of(const Masked& masked, std::uint32_t low, std::uint32_t high) {
  PairMask mask;
  if (masked.masks.has_hub[low] && masked.masks.has_hub[high])
    masked.masks.write_mask(masked.tree, masked.fans, low, high, mask);
  else if (const PairMask* known = find_mask(masked, low, high))
    mask = *known;
  return mask;
}

/// `neighbours` has the pairs of slots of the clusters with masks.
void expect_slots_of_neighbours(const Masked& masked) {
  const auto& nodes = masked.tree.nodes;
  for (std::uint32_t a = 0; a < nodes.size(); ++a)
    for (std::uint32_t b = a; b < nodes.size(); ++b) {
      detail::SlotMatrix expected = 0;
      for (std::uint32_t i = 0; i < nodes[a].cluster_count; ++i)
        for (std::uint32_t j = a == b ? i + 1 : 0; j < nodes[b].cluster_count; ++j)
          if (find_mask(masked, nodes[a].first_cluster + i, nodes[b].first_cluster + j))
            expected |= detail::slot_pair(i, j);
      EXPECT_EQ(masked.masks.neighbours(a, b), expected);
    }
}

/// Returns the number of pairs that share a surface vertex.
std::size_t expect_exactly_sharing_pairs(const Masked& masked) {
  const std::vector<std::uint32_t> surface = surface_vertices(masked.shape);
  const auto share = [&](std::uint32_t s, std::uint32_t t) {
    for (const std::uint32_t v : masked.shape.triangles[masked.tree.triangle_ids[s]])
      for (const std::uint32_t w : masked.shape.triangles[masked.tree.triangle_ids[t]])
        if (surface[v] == surface[w]) return true;
    return false;
  };
  expect_slots_of_neighbours(masked);
  std::size_t sharing = 0;
  const auto& clusters = masked.tree.clusters;
  for (std::uint32_t low = 0; low < clusters.size(); ++low)
    for (std::uint32_t high = low; high < clusters.size(); ++high) {
      const PairMask mask = mask_of(masked, low, high);
      for (std::uint32_t s = 0; s < clusters[low].triangle_count; ++s)
        for (std::uint32_t t = 0; t < clusters[high].triangle_count; ++t) {
          const bool shares =
              share(clusters[low].first_triangle + s, clusters[high].first_triangle + t);
          const bool is_lower_half = low == high && t <= s;
          EXPECT_EQ(mask.rows[s] >> t & 1, shares || is_lower_half);
          sharing += shares && !is_lower_half;
        }
    }
  return sharing;
}

bool has_hubs(const Masked& masked) {
  return std::count(masked.masks.has_hub.begin(), masked.masks.has_hub.end(), 1) > 0;
}

TEST(PairMasks, AreTheSharingPairsOfSurfaces) {
  Random random(1730);
  Shape limb = make_limb(24, 9, 4);
  for (int round = 0; round < 2; ++round) {
    const Masked masked(limb);
    EXPECT_GT(expect_exactly_sharing_pairs(masked), limb.triangles.size() * 5);
    EXPECT_FALSE(has_hubs(masked));
    split_corners(random, limb, 0.5, 0.2);
  }
}

TEST(PairMasks, AreTheSharingPairsOfSoups) {
  Random random(1731);
  int with_hubs = 0, without_hubs = 0;
  for (int round = 0; round < 40; ++round) {
    const Masked masked(make_grid_soup(random, 20 + random.index(200), 2 + random.index(6), 2));
    expect_exactly_sharing_pairs(masked);
    ++(has_hubs(masked) ? with_hubs : without_hubs);
  }
  EXPECT_GT(with_hubs, 3);
  EXPECT_GT(without_hubs, 3);
}

/// A limb whose triangles at one end also share hubs with fans of this size.
Shape with_hubs(Random& random, std::uint32_t size) {
  Shape shape = make_limb(10, 8, 3);
  for (int hub = 0; hub < 2; ++hub) add_fan(random, shape, size, hub == 0, shape.rest_positions[0]);
  return shape;
}

TEST(PairMasks, AreTheSharingPairsAroundHubs) {
  Random random(1732);
  const Masked masked(with_hubs(random, 400));
  EXPECT_TRUE(has_hubs(masked));
  EXPECT_GT(expect_exactly_sharing_pairs(masked), 400u * 799u);
  EXPECT_GT(std::count(masked.masks.has_hub.begin(), masked.masks.has_hub.end(), 0), 0);
}

std::size_t bytes_of(const PairMasks& masks) {
  return masks.masks.size() * (sizeof(PairMask) + sizeof(std::uint32_t)) +
         masks.begin.size() * sizeof(std::uint32_t) + masks.has_hub.size();
}

/// Random triangles between far-apart vertices: clusters share vertices with many others.
Shape make_tangle(Random& random, std::uint32_t triangle_count, std::uint32_t vertex_count) {
  Shape shape;
  shape.influences_per_vertex = 1;
  for (std::uint32_t v = 0; v < vertex_count; ++v) add_vertex(shape, random.point(1));
  for (std::uint32_t t = 0; t < triangle_count; ++t)
    shape.triangles.push_back(
        {random.index(vertex_count), random.index(vertex_count), random.index(vertex_count)});
  return shape;
}

TEST(PairMasks, NeedBoundedMemoryForAnyMesh) {
  Random random(1733);
  for (const std::uint32_t vertices : {4000u, 1200u, 600u, 60u, 10u, 4u}) {
    const Masked masked(make_tangle(random, 3000, vertices));
    std::printf("%u vertices: %zu bytes per triangle\n", vertices, bytes_of(masked.masks) / 3000);
    EXPECT_LE(bytes_of(masked.masks), 3000 * 900);
    EXPECT_LE(build_self_filter(masked.model)->memory_bytes(), 3000 * 1000);
  }
  Shape star;
  star.influences_per_vertex = 1;
  add_fan(random, star, 5000, false, {});
  EXPECT_LE(bytes_of(Masked(star).masks), 5000 * 40);
}

}  // namespace
}  // namespace pelt::test

namespace pelt::detail {
namespace {

bool has(SlotMatrix matrix, unsigned row, unsigned column) {
  return (matrix & slot_pair(row, column)) != 0;
}

TEST(SlotMatrix, ReadsRowsAndColumns) {
  test::Random random(1750);
  for (int round = 0; round < 200; ++round) {
    const SlotMatrix matrix = random.bits();
    for (unsigned i = 0; i < 8; ++i)
      for (unsigned j = 0; j < 8; ++j) {
        EXPECT_EQ(row_of(matrix, i) >> j & 1, has(matrix, i, j));
        EXPECT_EQ(column_of(matrix, j) >> i & 1, has(matrix, i, j));
        EXPECT_LT(row_of(matrix, i) | column_of(matrix, j), 256u);
      }
  }
}

TEST(SlotMatrix, ListsPairsOfSlots) {
  test::Random random(1751);
  for (unsigned rows = 0; rows <= 8; ++rows)
    for (unsigned columns = 0; columns <= 8; ++columns)
      for (unsigned i = 0; i < 8; ++i)
        for (unsigned j = 0; j < 8; ++j)
          EXPECT_EQ(has(first_slots(rows, columns), i, j), i < rows && j < columns);
  for (int round = 0; round < 200; ++round) {
    const unsigned rows = random.index(256), columns = random.index(256);
    for (unsigned i = 0; i < 8; ++i)
      for (unsigned j = 0; j < 8; ++j)
        EXPECT_EQ(has(all_pairs(rows, columns), i, j), (rows >> i & columns >> j & 1) != 0);
  }
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned j = 0; j < 8; ++j) EXPECT_EQ(has(kLaterSlots, i, j), j > i);
}

}  // namespace
}  // namespace pelt::detail
