#pragma once

/// Space divided into cubic cells. If two boxes overlap, both touch the cell of their
/// intersection's low corner, because the cell number of a coordinate is monotonic, also with
/// rounding. A pair that is found in several cells is reported in that cell only.
///
/// The hash table of Teschner et al. 2003 (hash.cpp): the cell (i, j, k) is at index (i 73856093
/// xor j 19349663 xor k 83492791) mod n. Time stamps replace clearing. Entries store their cell, so
/// entries of other cells at the same index are skipped.
///
/// The boxes of two sets that share a cell of a box that is divided into cells. The cells that each
/// set touches are marked in words of 64 bits; a word is a row along x. Few cells are marked by
/// both sets if surfaces merely touch. These cells are numbered by counting the bits before them,
/// and the first set's boxes are sorted into them.

#include "evaluation/rivals/box_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

namespace pelt::rivals {

using Cell = std::array<std::uint32_t, 3>;

/// The range of cells that a box touches.
struct CellRange {
  Cell low, high;

  std::uint64_t count() const {
    return std::uint64_t{high[0] - low[0] + 1} * (high[1] - low[1] + 1) * (high[2] - low[2] + 1);
  }

  template <typename Visit>
  void visit(const Visit& visit) const {
    for (std::uint32_t z = low[2]; z <= high[2]; ++z)
      for (std::uint32_t y = low[1]; y <= high[1]; ++y)
        for (std::uint32_t x = low[0]; x <= high[0]; ++x) visit(Cell{x, y, z});
  }
};

/// A box that touches more cells is entered in none, and is compared with everything. This bounds
/// memory and time if a triangle is much larger than a cell.
inline constexpr std::uint64_t kMaxCells = 64;

class CellGrid {
 public:
  /// The largest number of cells along an axis, so that the three numbers of a cell fit into 60
  /// bits.
  static constexpr std::uint32_t kMaxOnAxis = 1u << 20;

  CellGrid() = default;

  /// Cells of edge `edge`, numbered from the corner `low`. Everything beyond `last` belongs to
  /// `last`.
  CellGrid(const Float4& low, float edge, const Cell& last)
      : low_(low),
        scale_(1 / std::max(edge, std::numeric_limits<float>::min())),
        last_(static_cast<float>(last[0]), static_cast<float>(last[1]), static_cast<float>(last[2]),
              0) {}

  Cell cell_of(const Float4& point) const {
    const Float4 cells = min(max(Float4(scale_) * (point - low_), Float4(0.0f)), last_);
    return {static_cast<std::uint32_t>(cells[0]), static_cast<std::uint32_t>(cells[1]),
            static_cast<std::uint32_t>(cells[2])};
  }

  CellRange cells_of(const Box4& box) const { return {cell_of(box.low), cell_of(box.high)}; }

  bool is_first_common_cell(const Cell& cell, const Box4& a, const Box4& b) const {
    return cell_of(max(a.low, b.low)) == cell;
  }

 private:
  Float4 low_ = Float4(0.0f);
  float scale_ = 0;
  Float4 last_ = Float4(0.0f);
};

/// Cells of edge `edge` from the corner `low`, up to the largest cell number.
inline CellGrid endless_grid(const Float4& low, float edge) {
  constexpr std::uint32_t kLast = CellGrid::kMaxOnAxis - 1;
  return {low, edge, {kLast, kLast, kLast}};
}

/// The mean length of the triangles' edges.
float mean_edge(std::span<const Triangle> triangles, std::span<const Vec3> positions);

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

class CommonCells {
 public:
  /// Both sets must outlive this object or the next call. All their boxes must overlap `where`.
  /// Cells have the edge `edge`, or a larger one if there would be too many cells.
  void sort(std::span<const NumberedBox> a, std::span<const NumberedBox> b, const Box4& where,
            float edge);

  /// Calls `visit(box)` once for each box of the first set that overlaps box j of the second.
  template <typename Visit>
  void visit_overlapping(std::uint32_t j, const Visit& visit) const {
    const Box4 box = b_[j].box();
    const CellRange& cells = cells_b_[j];
    if (is_large(cells)) return visit_if_overlapping(a_, box, visit);
    visit_if_overlapping(large_, box, visit);
    visit_common_cells(cells, [&](const Cell& cell, std::uint32_t number) {
      visit_if_overlapping({entries_.data() + begin_[number], entries_.data() + begin_[number + 1]},
                           box, [&](const NumberedBox& other) {
                             if (grid_.is_first_common_cell(cell, other.box(), box)) visit(other);
                           });
    });
  }

 private:
  using Rows = std::vector<std::uint64_t>;

  static bool is_large(const CellRange& cells) { return cells.count() > kMaxCells; }

  template <typename Visit>
  static void visit_if_overlapping(std::span<const NumberedBox> boxes, const Box4& box,
                                   const Visit& visit) {
    for (const NumberedBox& other : boxes)
      if (overlap(other.box(), box)) visit(other);
  }

  void choose_cells(const Box4& where, float edge);
  void mark(std::span<const NumberedBox> boxes, std::vector<CellRange>& cells, Rows& marked) const;
  void number_common_cells();
  void sort_first_set();

  /// Calls `visit(row, bits, y, z)` for the rows of a range of cells.
  template <typename Visit>
  void visit_rows(const CellRange& cells, const Visit& visit) const {
    const std::uint64_t bits =
        (~std::uint64_t{0} >> (63 - cells.high[0])) & (~std::uint64_t{0} << cells.low[0]);
    for (std::uint32_t z = cells.low[2]; z <= cells.high[2]; ++z)
      for (std::uint32_t y = cells.low[1]; y <= cells.high[1]; ++y)
        visit(z * sizes_[1] + y, bits, y, z);
  }

  /// Calls `visit(cell, number)` for the common cells.
  template <typename Visit>
  void visit_common_cells(const CellRange& cells, const Visit& visit) const {
    visit_rows(cells, [&](std::uint32_t row, std::uint64_t bits, std::uint32_t y, std::uint32_t z) {
      for (std::uint64_t left = common_[row] & bits; left != 0; left &= left - 1) {
        const auto x = static_cast<std::uint32_t>(std::countr_zero(left));
        const std::uint64_t before = common_[row] & ((std::uint64_t{1} << x) - 1);
        visit(Cell{x, y, z},
              first_number_[row] + static_cast<std::uint32_t>(std::popcount(before)));
      }
    });
  }

  std::span<const NumberedBox> a_, b_;
  CellGrid grid_;
  Cell sizes_ = {};
  std::vector<CellRange> cells_a_, cells_b_;  // of the boxes
  Rows common_, marked_b_;                    // a bit for each cell
  std::vector<std::uint32_t> first_number_;   // by row: the number of its first common cell
  std::vector<std::uint32_t> begin_;          // by common cell: index into entries_; then the end
  std::vector<NumberedBox> entries_;          // boxes of the first set, cell by cell
  std::vector<NumberedBox> large_;            // boxes of the first set that touch too many cells
};

}  // namespace pelt::rivals
