#pragma once

/// Access to the open items by rank. Pushing and popping take constant time.

#include "base/instruction_set.hpp"
#include "collide/search_state.hpp"

#include <bit>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

class OpenQueue {
 public:
  explicit OpenQueue(OpenItems& items) : items_(items) {}

  bool is_empty() const { return items_.count == 0; }
  std::uint32_t size() const { return items_.count; }

  OpenItem& operator[](std::uint32_t place) { return items_.pool.begin()[place]; }

  /// Returns the place of a new item, which the caller writes in place, because copying what was
  /// just written stalls the processor.
  std::uint32_t make() {
    const std::uint32_t place = items_.unused;
    if (place != kNoItem) {
      items_.unused = (*this)[place].next;
      return place;
    }
    items_.pool.push({});
    return static_cast<std::uint32_t>(items_.pool.size() - 1);
  }

  /// Pushes an item that was made before.
  void push(std::uint32_t place, std::uint32_t rank) {
    OpenItem& item = (*this)[place];
    item.next = items_.heads[rank];
    item.rank = static_cast<std::uint8_t>(rank);
    items_.heads[rank] = place;
    items_.occupied[rank / 64] |= std::uint64_t{1} << rank % 64;
    ++items_.count;
  }

  /// Precondition: not empty.
  OpenItem pop() {
    const std::uint32_t rank = highest_rank(), place = items_.heads[rank];
    OpenItem& top = items_.pool.begin()[place];
    const OpenItem item = top;
    items_.heads[rank] = item.next;
    if (item.next == kNoItem) items_.occupied[rank / 64] &= ~(std::uint64_t{1} << rank % 64);
    top.next = items_.unused;
    items_.unused = place;
    --items_.count;
    return item;
  }

 private:
  std::uint32_t highest_rank() const {
    std::uint32_t word = OpenItems::kRanks / 64 - 1;
    while (items_.occupied[word] == 0) --word;
    return 64 * word + 63 - static_cast<std::uint32_t>(std::countl_zero(items_.occupied[word]));
  }

  OpenItems& items_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
