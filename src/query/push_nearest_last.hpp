#pragma once

/// Slots of a node, nearest first.

#include "base/float8.hpp"
#include "query/lanes.hpp"
#include "query/tree_part.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Pushes `make(slot, gap)` for each slot of `slots`, the nearest last.
template <typename Item, typename Make>
void push_nearest_last(Stack<Item>& items, unsigned slots, const Float8& squared_gaps,
                       const Make& make) {
  alignas(32) float gap[kMaxSlots];
  squared_gaps.store(gap);
  const std::size_t first = items.size();
  for (SetBits slot(slots); slot; ++slot) {
    items.push(make(*slot, gap[*slot]));
    const Item moved = items.end()[-1];
    Item* place = items.end() - 1;
    for (; place > items.begin() + first && place[-1].squared_gap < moved.squared_gap; --place)
      *place = place[-1];
    *place = moved;
  }
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
