#include "collide/search_answers.hpp"

#include "model/triangles_below.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {
namespace {

std::uint64_t triangles_in(const Tree& tree, std::uint32_t index, unsigned slots) {
  const Node& node = tree.nodes[index];
  std::uint64_t count = 0;
  for (unsigned slot = 0; slot < unsigned{node.cluster_count} + node.child_count; ++slot)
    if (slots >> slot & 1) count += triangles_below(tree, node, slot);
  return count;
}

std::uint64_t pairs_of(const OpenItem& item, const Tree& a, const Tree& b) {
  return triangles_in(a, item.node_a, item.slots_a) * triangles_in(b, item.node_b, item.slots_b);
}

double longest_side(const OpenItem& item) {
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, static_cast<double>(item.high[axis]) - item.low[axis]);
  return longest;
}

}  // namespace

Verdict verdict_of(const SearchState& state) {
  if (!state.found.empty()) return Verdict::touching;
  return state.items.count == 0 ? Verdict::apart : Verdict::unknown;
}

std::uint64_t undecided_pairs(const SearchState& state, const Tree& a, const Tree& b) {
  std::uint64_t pairs = 0;
  each_open(state.items, [&](const OpenItem& item) { pairs += pairs_of(item, a, b); });
  return pairs;
}

double resolution_of(const SearchState& state) {
  double longest = 0;
  each_open(state.items,
            [&](const OpenItem& item) { longest = std::max(longest, longest_side(item)); });
  return longest;
}

/// The squared distance was computed from rounded differences.
double distance_bound(const SearchState& state) {
  return state.found.empty() ? std::sqrt(state.squared_reach) * (1 + 0x1p-20) : 0;
}

void append_open_regions(const SearchState& state, const Tree& a, const Tree& b,
                         std::vector<OpenRegion>& regions) {
  each_open(state.items, [&](const OpenItem& item) {
    const Box region = {{item.low[0], item.low[1], item.low[2]},
                        {item.high[0], item.high[1], item.high[2]}};
    regions.push_back({region, item.depth, pairs_of(item, a, b)});
  });
}

}  // namespace pelt::detail
