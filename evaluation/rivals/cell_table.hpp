#pragma once

/// The hash table of Teschner et al. 2003 (hash.hpp): the cell (i, j, k) is at index (i 73856093
/// xor j 19349663 xor k 83492791) mod n. Time stamps replace clearing. Entries store their cell, so
/// entries of other cells at the same index are skipped.

#include "evaluation/rivals/cell_grid.hpp"

#include <bit>
#include <vector>

namespace pelt::rivals {

/// The items of each cell.
class CellTable {
 public:
  /// Sized for about `item_count` items; more items make it slower.
  explicit CellTable(std::size_t item_count)
      : places_(std::bit_ceil(2 * item_count)), mask_(places_.size() - 1) {}

  void clear() {
    entries_.clear();
    if (++stamp_ != 0) return;
    std::fill(places_.begin(), places_.end(), Place{});
    stamp_ = 1;
  }

  void add(const Cell& cell, std::uint32_t item) {
    Place& place = places_[place_of(cell)];
    const std::uint32_t next = place.stamp == stamp_ ? place.last_entry : kNone;
    place = {stamp_, static_cast<std::uint32_t>(entries_.size())};
    entries_.push_back({key_of(cell), item, next});
  }

  /// Calls `visit(item)` for all items of a cell.
  template <typename Visit>
  void visit(const Cell& cell, const Visit& visit) const {
    const Place& place = places_[place_of(cell)];
    if (place.stamp != stamp_) return;
    const std::uint64_t key = key_of(cell);
    for (std::uint32_t e = place.last_entry; e != kNone; e = entries_[e].next)
      if (entries_[e].key == key) visit(entries_[e].item);
  }

 private:
  static constexpr std::uint32_t kNone = ~0u;

  struct Place {
    std::uint32_t stamp = 0, last_entry = 0;
  };

  struct Entry {
    std::uint64_t key;
    std::uint32_t item, next;
  };

  std::size_t place_of(const Cell& cell) const {
    return (cell[0] * 73856093u ^ cell[1] * 19349663u ^ cell[2] * 83492791u) & mask_;
  }

  static std::uint64_t key_of(const Cell& cell) {
    return cell[0] | std::uint64_t{cell[1]} << 20 | std::uint64_t{cell[2]} << 40;
  }

  std::vector<Place> places_;
  std::size_t mask_;
  std::vector<Entry> entries_;
  std::uint32_t stamp_ = 0;
};

}  // namespace pelt::rivals
