#pragma once

/// Open items of a search by rank: a queue that pushes and pops in constant time, and the ranks.

#include "base/bits.hpp"
#include "base/instruction_set.hpp"
#include "collide/search.hpp"

#include <algorithm>
#include <array>
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

  /// Returns the place of a new item, which the caller constructs there: a copy of what was just
  /// written stalls the processor.
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

// Ranks of open items by the order of a search. A rank is computed from the bits of one float, so
// it is the same on every machine.

/// The sides of the item's region in ascending order.
inline std::array<float, 3> sorted_sides(const OpenItem& item) {
  std::array<float, 3> sides = {item.high[0] - item.low[0], item.high[1] - item.low[1],
                                item.high[2] - item.low[2]};
  if (sides[0] > sides[1]) std::swap(sides[0], sides[1]);
  if (sides[1] > sides[2]) std::swap(sides[1], sides[2]);
  if (sides[0] > sides[1]) std::swap(sides[0], sides[1]);
  return sides;
}

/// Ranks floats that are not negative on a logarithmic scale of eight steps for each power of two.
/// `most` has the highest rank below kDepthFirst. Floats below most / 2^31 share the lowest rank.
inline std::uint32_t logarithmic_rank(float value, float most) {
  constexpr int kHighest = static_cast<int>(OpenItems::kDepthFirst) - 1;
  const auto steps = [](float x) { return static_cast<int>(bits_as<std::uint32_t>(x) >> 20); };
  return static_cast<std::uint32_t>(std::clamp(kHighest - steps(most) + steps(value), 0, kHighest));
}

/// Ranks by the depth of the overlap, relative to the length of the region: surfaces that cross
/// deeply have many contacts, and those that graze each other have few. The rank is the mean with
/// that of the item which it is a part of, because the boxes of small parts say less about them.
inline std::uint32_t rank_by_depth(const OpenItem& item, std::uint32_t rank_of_whole) {
  const float length = sorted_sides(item)[2];
  const std::uint32_t rank =
      length > 0 ? logarithmic_rank(item.depth, length) : OpenItems::kDepthFirst - 1;
  return rank_of_whole == OpenItems::kDepthFirst ? rank : (rank + rank_of_whole) / 2;
}

/// Opening nodes is most of the work, so items whose nodes are both open are always next.
inline std::uint32_t rank_for_contacts(const SearchState& state, const OpenItem& item,
                                       std::uint32_t rank_of_whole) {
  return is_needed(state.needed_a, item.node_a) && is_needed(state.needed_b, item.node_b)
             ? OpenItems::kDepthFirst
             : rank_by_depth(item, rank_of_whole);
}

/// The rank of an item that is a part of another one.
inline std::uint32_t rank_of(const SearchState& state, const OpenItem& item,
                             std::uint32_t rank_of_whole) {
  switch (state.order) {
    case SearchOrder::first_contact:
      return OpenItems::kDepthFirst;
    case SearchOrder::resolution:
      return logarithmic_rank(sorted_sides(item)[2], state.whole_size);
    case SearchOrder::contacts:
      return rank_for_contacts(state, item, rank_of_whole);
  }
  return 0;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
