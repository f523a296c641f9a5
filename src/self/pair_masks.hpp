#pragma once

/// Bit masks of the pairs of triangles that share a surface vertex, for each two clusters that are
/// neighbours. The descent of a tree against itself skips these pairs, because they are found fan
/// by fan.

#include "self/fans.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// One bit for each pair of triangles of two clusters: bit t of row s for triangle s of the first
/// cluster and triangle t of the second.
struct PairMask {
  std::uint16_t rows[kMaxClusterTriangles] = {};

  void set(std::uint32_t row, std::uint32_t lane) {
    rows[row] = static_cast<std::uint16_t>(rows[row] | 1u << lane);
  }
};

struct PairMasks {
  PairMasks(const Tree& tree, const Fans& fans);

  /// For each cluster, its mask with itself, and then those with its neighbours of higher numbers,
  /// ascending. Neighbours are clusters with a common surface vertex that is not a hub. In the mask
  /// of a cluster with itself, bits with t <= s are set, too.
  std::vector<std::uint32_t> begin;  // [C + 1] into masks
  std::vector<PairMask> masks;
  std::vector<std::uint32_t> cluster_nodes;  // [C] node of each cluster

  /// The nodes of a cluster's neighbours, ascending, and the slots of the neighbours in each node,
  /// one bit per slot.
  std::vector<std::uint32_t> near_begin;  // [C + 1] into near_nodes and near_slots
  std::vector<std::uint32_t> near_nodes;
  std::vector<std::uint8_t> near_slots;

  /// A hub is a surface vertex that the masks leave out. Small fans are covered first, until a
  /// limit of memory is reached.
  std::vector<std::uint8_t> has_hub;  // [C] whether a triangle of the cluster has a hub

  /// Writes a mask as in `masks`, for clusters with hubs. Precondition: low <= high.
  void write_mask(const Tree& tree, const Fans& fans, std::uint32_t low, std::uint32_t high,
                  PairMask& mask) const;

  /// Calls visit(index into masks, node, slot) for each mask of a cluster; node and slot are those
  /// of the other cluster.
  template <typename Visit>
  void for_each(const Tree& tree, std::uint32_t cluster, const Visit& visit) const {
    std::uint32_t mask = begin.data()[cluster];
    const std::uint32_t own = cluster_nodes.data()[cluster];
    visit(mask++, own, cluster - tree.nodes.data()[own].first_cluster);
    for (std::uint32_t i = near_begin.data()[cluster]; i < near_begin.data()[cluster + 1]; ++i) {
      const std::uint32_t node = near_nodes.data()[i];
      const std::uint32_t first = tree.nodes.data()[node].first_cluster;
      for (unsigned slots = near_slots.data()[i]; slots != 0; slots &= slots - 1) {
        const auto slot = static_cast<std::uint32_t>(std::countr_zero(slots));
        if (first + slot > cluster) visit(mask++, node, slot);
      }
    }
  }

  /// Returns the neighbours of a cluster in a node, as bits of slots.
  unsigned neighbours_in(std::uint32_t cluster, std::uint32_t node) const {
    for (std::uint32_t i = near_begin.data()[cluster]; i < near_begin.data()[cluster + 1]; ++i)
      if (near_nodes.data()[i] == node) return near_slots.data()[i];
    return 0;
  }

 private:
  void write_masks(const std::vector<std::uint64_t>& sorted, std::size_t cluster_count);
  void write_near_slots(const std::vector<std::uint64_t>& sorted, const Tree& tree);
};

}  // namespace pelt::detail
