#pragma once

/// Pairs of slots of two nodes as a bit matrix: bit 8 i + j for slot i of the first node and slot j
/// of the second.

#include "model/tree.hpp"

#include <cstdint>

namespace pelt::detail {

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

}  // namespace pelt::detail
