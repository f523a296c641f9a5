#pragma once

/// What the state of a search says about two poses.

#include "collide/search_state.hpp"
#include "model/tree.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Calls `visit(item)` for each open item, next ones first.
template <typename Visit>
void each_open(const OpenItems& items, const Visit& visit) {
  for (std::uint32_t rank = OpenItems::kRanks; rank-- > 0;)
    for (std::uint32_t i = items.heads[rank]; i != kNoItem; i = items.at(i).next)
      visit(items.at(i));
}

Verdict verdict_of(const SearchState& state);

/// Number of pairs of triangles of all open items.
std::uint64_t undecided_pairs(const SearchState& state, const Tree& a, const Tree& b);

/// Longest side of the region of any open item.
double resolution_of(const SearchState& state);

/// Upper bound of the distance of the two poses.
double distance_bound(const SearchState& state);

/// Appends the open items.
void append_open_regions(const SearchState& state, const Tree& a, const Tree& b,
                         std::vector<OpenRegion>& regions);

}  // namespace pelt::detail
