#pragma once

/// Ranks of open items by the order of a search. A rank is computed from the bits of one float, so
/// it is the same on every machine.

#include "base/bits.hpp"
#include "base/instruction_set.hpp"
#include "search/search_state.hpp"

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

/// Deep crossings of surfaces have regions that are about as thick as long, and grazing ones have
/// thin regions.
inline std::uint32_t rank_by_thickness(const OpenItem& item) {
  const std::array<float, 3> sides = sorted_sides(item);
  return sides[2] > 0 ? logarithmic_rank(sides[0] / sides[2], 1) : OpenItems::kDepthFirst - 1;
}

inline std::uint32_t rank_of(const SearchState& state, const OpenItem& item) {
  switch (state.order) {
    case SearchOrder::first_contact:
      return OpenItems::kDepthFirst;
    case SearchOrder::resolution:
      return logarithmic_rank(sorted_sides(item)[2], state.whole_size);
    case SearchOrder::contacts:
      return rank_by_thickness(item);
  }
  return 0;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
