#include "volume/node_windings.hpp"

#include <algorithm>

namespace pelt::detail {
NodeWindings::NodeWindings(const Tree& tree, const Node& node, std::span<const WindingTurns> turns)
    : tree_(tree), places_(places_of(tree, node)) {
  std::fill_n(windings_.begin(), node.vertex_count, kUnknown);
  std::fill_n(turns_.begin(), places_.end - places_.first, std::array<std::int32_t, 3>());
  const auto is_before = [](const WindingTurns& t, std::uint32_t place) { return t.place < place; };
  for (auto turn = std::lower_bound(turns.begin(), turns.end(), places_.first, is_before);
       turn != turns.end() && turn->place < places_.end; ++turn) {
    std::array<std::int32_t, 3>& sum = turns_[turn->place - places_.first];
    sum[1] += turn->to[0];
    sum[2] += turn->to[1];
  }
}

void NodeWindings::set(std::uint32_t place, std::int32_t winding) {
  windings_[vertex(place, 0)] = winding;
  bool has_spread = true;
  while (has_spread) {
    has_spread = false;
    for (std::uint32_t i = places_.first; i < places_.end; ++i) has_spread |= spread(i);
    for (std::uint32_t i = places_.end; i-- > places_.first;) has_spread |= spread(i);
  }
}

/// Returns whether more is known than before.
bool NodeWindings::spread(std::uint32_t place) {
  const std::array<std::int32_t, 3>& turns = turns_[place - places_.first];
  const std::array corners = {vertex(place, 0), vertex(place, 1), vertex(place, 2)};
  const auto is_known_at = [&](std::size_t corner) {
    return windings_[corners[corner]] != kUnknown;
  };
  const std::array known = {is_known_at(0), is_known_at(1), is_known_at(2)};
  if (known[0] == known[1] && known[1] == known[2]) return false;
  const std::size_t from = known[0] ? 0 : known[1] ? 1 : 2;
  const std::int32_t base = windings_[corners[from]] - turns[from];
  for (std::size_t k = 0; k < 3; ++k) windings_[corners[k]] = base + turns[k];
  return true;
}

}  // namespace pelt::detail
