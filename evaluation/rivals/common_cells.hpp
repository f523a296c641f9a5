#pragma once

/// The boxes of two sets that share a cell of a box that is divided into cells. The cells that each
/// set touches are marked in words of 64 bits; a word is a row along x. Few cells are marked by
/// both sets if surfaces merely touch. These cells are numbered by counting the bits before them,
/// and the first set's boxes are sorted into them.

#include "evaluation/rivals/cell_grid.hpp"

#include <bit>
#include <vector>

namespace pelt::rivals {

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
