#pragma once

/// Ranks of open items by the order of a search. A rank is computed from the bits of one float, so
/// it is the same on every machine.

#include "base/bits.hpp"
#include "base/instruction_set.hpp"
#include "collide/search_state.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

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
