#pragma once

/// The cells of a height field below or above a box.

#include "base/instruction_set.hpp"
#include "field/height_field.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A closed box in the frame of the field.
struct FieldBox {
  float low[3], high[3];
};

/// A rectangle of cells, vertices or blocks, including the last ones.
struct FieldRect {
  std::uint32_t first_column, last_column, first_row, last_row;
};

/// Returns the first of `count` intervals between ascending `places` that is not wholly before
/// `low`, or `count` if there is none. `guess` is its approximate index.
inline std::uint32_t first_interval(const float* places, std::uint32_t count, float low,
                                    float guess) {
  const auto most = static_cast<float>(count - 1);
  auto i = static_cast<std::uint32_t>(!(guess > 0) ? 0 : guess < most ? guess : most);
  if (i >= count) i = count - 1;
  while (i > 0 && places[i] >= low) --i;
  while (i < count && places[i + 1] < low) ++i;
  return i;
}

/// Returns the last interval that is not wholly beyond `high`. Precondition: the first one is not.
inline std::uint32_t last_interval(const float* places, std::uint32_t count, float high,
                                   float guess) {
  const auto most = static_cast<float>(count - 1);
  auto i = static_cast<std::uint32_t>(!(guess > 0) ? 0 : guess < most ? guess : most);
  if (i >= count) i = count - 1;
  while (i + 1 < count && places[i + 1] <= high) ++i;
  while (places[i] > high) --i;
  return i;
}

/// Finds the cells that the box overlaps in its projection along y. Returns false if there are
/// none.
inline bool find_cells(const HeightField& field, const FieldBox& box, FieldRect& cells) {
  const float *x = field.x.data(), *z = field.z.data();
  const std::uint32_t columns = field.columns() - 1, rows = field.rows() - 1;
  if (!(x[0] <= box.high[0] && z[0] <= box.high[2])) return false;
  const float per_x = field.columns_per_x, per_z = field.rows_per_z;
  cells.first_column = first_interval(x, columns, box.low[0], (box.low[0] - x[0]) * per_x);
  cells.first_row = first_interval(z, rows, box.low[2], (box.low[2] - z[0]) * per_z);
  if (cells.first_column == columns || cells.first_row == rows) return false;
  cells.last_column = last_interval(x, columns, box.high[0], (box.high[0] - x[0]) * per_x);
  cells.last_row = last_interval(z, rows, box.high[2], (box.high[2] - z[0]) * per_z);
  return true;
}

/// Returns the blocks of a level that contain the cells.
inline FieldRect blocks_around(const FieldRect& cells, std::uint32_t level) {
  const std::uint32_t shift = kBlockShift + level;
  return {cells.first_column >> shift, cells.last_column >> shift, cells.first_row >> shift,
          cells.last_row >> shift};
}

/// Returns the lowest level on which at most four blocks contain the cells.
inline std::uint32_t level_of(const FieldRect& cells) {
  for (std::uint32_t level = 0;; ++level) {
    const FieldRect blocks = blocks_around(cells, level);
    if (blocks.last_column - blocks.first_column <= 1 && blocks.last_row - blocks.first_row <= 1)
      return level;
  }
}

inline const HeightRange& block_at(const HeightField& field, std::uint32_t level,
                                   std::uint32_t column, std::uint32_t row) {
  const FieldLevel& blocks = field.levels.data()[level];
  return blocks.blocks.data()[std::size_t{row} * blocks.columns + column];
}

/// Bounds of the heights of all these cells, in at most four steps.
inline HeightRange heights_of(const HeightField& field, const FieldRect& cells) {
  const std::uint32_t level = level_of(cells);
  const FieldRect blocks = blocks_around(cells, level);
  HeightRange range = block_at(field, level, blocks.first_column, blocks.first_row);
  for (std::uint32_t row = blocks.first_row; row <= blocks.last_row; ++row)
    for (std::uint32_t column = blocks.first_column; column <= blocks.last_column; ++column) {
      const HeightRange& block = block_at(field, level, column, row);
      if (block.low < range.low) range.low = block.low;
      if (block.high > range.high) range.high = block.high;
    }
  return range;
}

/// Whether heights and a box overlap; touching counts.
inline bool overlap(const HeightRange& heights, const FieldBox& box) {
  return heights.low <= box.high[1] && box.low[1] <= heights.high;
}

/// A triangle of a height field.
struct FieldTriangle {
  std::uint32_t number;
  float corners[3][4];  ///< x, y, z and anything
};

/// Calls `visit` with the triangles of the cells `within` whose boxes may overlap `box`, block by
/// block.
template <typename Visit>
class FieldTriangles {
 public:
  FieldTriangles(const HeightField& field, const FieldBox& box, const FieldRect& within,
                 const Visit& visit)
      : field_(field), box_(box), within_(within), visit_(visit) {}

  void run() const {
    const std::uint32_t level = level_of(within_);
    const FieldRect blocks = blocks_around(within_, level);
    for (std::uint32_t row = blocks.first_row; row <= blocks.last_row; ++row)
      for (std::uint32_t column = blocks.first_column; column <= blocks.last_column; ++column)
        visit_block(level, column, row);
  }

 private:
  static std::uint32_t larger(std::uint32_t a, std::uint32_t b) { return a < b ? b : a; }
  static std::uint32_t smaller(std::uint32_t a, std::uint32_t b) { return a < b ? a : b; }

  void visit_block(std::uint32_t level, std::uint32_t column, std::uint32_t row) const {
    if (!overlap(block_at(field_, level, column, row), box_)) return;
    if (level == 0) return visit_cells(column << kBlockShift, row << kBlockShift);
    const FieldRect all = blocks_around(within_, level - 1);
    for (std::uint32_t r = larger(2 * row, all.first_row); r <= smaller(2 * row + 1, all.last_row);
         ++r)
      for (std::uint32_t c = larger(2 * column, all.first_column);
           c <= smaller(2 * column + 1, all.last_column); ++c)
        visit_block(level - 1, c, r);
  }

  void visit_cells(std::uint32_t column, std::uint32_t row) const {
    constexpr std::uint32_t kLast = (1u << kBlockShift) - 1;
    for (std::uint32_t r = larger(row, within_.first_row);
         r <= smaller(row + kLast, within_.last_row); ++r)
      for (std::uint32_t c = larger(column, within_.first_column);
           c <= smaller(column + kLast, within_.last_column); ++c)
        visit_cell(c, r);
  }

  void visit_cell(std::uint32_t column, std::uint32_t row) const {
    const float* y = field_.y.data() + std::size_t{row} * field_.columns() + column;
    const float* next = y + field_.columns();
    const std::uint32_t number = 2 * (row * (field_.columns() - 1) + column);
    const float *x = field_.x.data() + column, *z = field_.z.data() + row;
    if (overlaps(y[0], next[0], next[1]))
      visit_(FieldTriangle{number,
                           {{x[0], y[0], z[0]}, {x[0], next[0], z[1]}, {x[1], next[1], z[1]}}});
    if (overlaps(y[0], next[1], y[1]))
      visit_(FieldTriangle{number + 1,
                           {{x[0], y[0], z[0]}, {x[1], next[1], z[1]}, {x[1], y[1], z[0]}}});
  }

  /// Whether a triangle with these heights exists and overlaps the box. Comparisons with NaN, the
  /// height of a hole, are false.
  bool overlaps(float a, float b, float c) const {
    const float low = box_.low[1], high = box_.high[1];
    const bool exists = a == a && b == b && c == c;
    return exists && (a <= high || b <= high || c <= high) && (low <= a || low <= b || low <= c);
  }

  const HeightField& field_;
  const FieldBox& box_;
  const FieldRect& within_;
  const Visit& visit_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
