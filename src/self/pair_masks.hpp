#pragma once

/// Bit masks of the pairs of triangles that share a surface vertex, for each two clusters that are
/// neighbours. The descent of a tree against itself skips these pairs, because they are found fan
/// by fan.

#include "model/tree.hpp"
#include "self/fans.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Pairs of slots of two nodes as a bit matrix: bit 8 i + j for slot i of the first node and slot j
/// of the second.
using SlotMatrix = std::uint64_t;

static_assert(kMaxSlots == 8);

/// Bit 0 of each row.
inline constexpr SlotMatrix kFirstColumn = 0x0101010101010101;

/// Slot j > slot i.
inline constexpr SlotMatrix kLaterSlots = 0x0080C0E0F0F8FCFE;

inline SlotMatrix slot_pair(std::uint32_t row, std::uint32_t column) {
  return SlotMatrix{1} << (8 * row + column);
}

/// All pairs of the first `rows` and the first `columns` slots.
inline SlotMatrix first_slots(std::uint32_t rows, std::uint32_t columns) {
  const SlotMatrix kept_rows = rows < 8 ? (SlotMatrix{1} << 8 * rows) - 1 : ~SlotMatrix{0};
  return kept_rows & kFirstColumn * ((1u << columns) - 1);
}

/// All pairs of these rows and these columns, one bit each.
inline SlotMatrix all_pairs(unsigned rows, unsigned columns) {
  SlotMatrix matrix = 0;
  for (unsigned row = 0; row < 8; ++row) matrix |= SlotMatrix{rows >> row & 1} << 8 * row;
  return matrix * columns;
}

inline unsigned row_of(SlotMatrix matrix, std::uint32_t row) {
  return static_cast<unsigned>(matrix >> 8 * row) & 0xFF;
}

/// The multiplication moves bit 8 i to bit 56 + i.
inline unsigned column_of(SlotMatrix matrix, std::uint32_t column) {
  return static_cast<unsigned>((matrix >> column & kFirstColumn) * 0x0102040810204080 >> 56);
}

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
  std::vector<std::uint32_t> others;         // the second cluster of each mask
  std::vector<std::uint32_t> cluster_nodes;  // [C] node of each cluster

  /// For each node, the nodes of the neighbours of its clusters, itself included, from itself on,
  /// ascending; and the pairs of slots of the two nodes that are neighbours.
  std::vector<std::uint32_t> near_begin;  // [N + 1] into near_nodes and near_slots
  std::vector<std::uint32_t> near_nodes;
  std::vector<SlotMatrix> near_slots;

  /// A hub is a surface vertex that the masks leave out. Small fans are covered first, until a
  /// limit of memory is reached.
  std::vector<std::uint8_t> has_hub;  // [C] whether a triangle of the cluster has a hub

  /// Writes a mask as in `masks`, for clusters with hubs. Precondition: low <= high.
  void write_mask(const Tree& tree, const Fans& fans, std::uint32_t low, std::uint32_t high,
                  PairMask& mask) const;

  /// Returns the pairs of clusters of two nodes that are neighbours. Precondition: a <= b.
  SlotMatrix neighbours(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = near_begin.data()[a]; i < near_begin.data()[a + 1]; ++i)
      if (near_nodes.data()[i] == b) return near_slots.data()[i];
    return 0;
  }

 private:
  void write_masks(const std::vector<std::uint64_t>& sorted, std::size_t cluster_count);
  void write_near_slots(const Tree& tree);
};

}  // namespace pelt::detail
