#pragma once

/// A height field, prepared for queries: the coordinates of its vertices, and a pyramid with the
/// least and greatest heights of square blocks of cells. A block of the lowest level has
/// kBlockCells cells per side, a block of the next level twice as many, up to a level with a single
/// block.

#include <pelt/height_field.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Blocks of level n have 2^(kBlockShift + n) cells per side.
inline constexpr std::uint32_t kBlockShift = 2;

struct HeightRange {
  float low, high;  ///< +infinity and -infinity if there are only holes
};

struct FieldLevel {
  std::uint32_t columns = 0, rows = 0;  // of blocks
  std::vector<HeightRange> blocks;      // [rows][columns]
};

struct HeightField {
  std::vector<float> x, z;  // of columns and rows, strictly ascending
  std::vector<float> y;     // [rows][columns]; NaN: a hole
  std::vector<FieldLevel> levels;
  float columns_per_x, rows_per_z;  // approximate

  std::uint32_t columns() const { return static_cast<std::uint32_t>(x.size()); }
  std::uint32_t rows() const { return static_cast<std::uint32_t>(z.size()); }

  /// Like `pelt::HeightField::triangle`.
  std::array<Vec3, 3> triangle(std::uint32_t number) const;
};

}  // namespace pelt::detail
