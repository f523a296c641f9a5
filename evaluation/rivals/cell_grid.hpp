#pragma once

/// Space divided into cubic cells. If two boxes overlap, both touch the cell of their
/// intersection's low corner, because the cell number of a coordinate is monotonic, also with
/// rounding. A pair that is found in several cells is reported in that cell only.

#include "evaluation/rivals/box.hpp"

#include <algorithm>
#include <array>
#include <limits>

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

}  // namespace pelt::rivals
