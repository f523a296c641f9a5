#include "evaluation/rivals/cell_grid.hpp"

#include "base/vec3.hpp"

#include <cmath>

namespace pelt::rivals {

float mean_edge(std::span<const Triangle> triangles, std::span<const Vec3> positions) {
  double sum = 0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const detail::Vec3d from(positions[t[k]]), to(positions[t[(k + 1) % 3]]);
      sum += std::sqrt(squared_length(to - from));
    }
  return static_cast<float>(sum / (3.0 * static_cast<double>(triangles.size())));
}

namespace {

constexpr double kMaxInRow = 64;

/// With this limit, the rows take at most 128 KiB per set: they are cleared in every query and stay
/// in the cache.
constexpr double kMaxRows = 0x1p14;

}  // namespace

void CommonCells::sort(std::span<const NumberedBox> a, std::span<const NumberedBox> b,
                       const Box4& where, float edge) {
  a_ = a;
  b_ = b;
  choose_cells(where, edge);
  mark(a, cells_a_, common_);
  mark(b, cells_b_, marked_b_);
  for (std::size_t row = 0; row < common_.size(); ++row) common_[row] &= marked_b_[row];
  number_common_cells();
  sort_first_set();
}

void CommonCells::choose_cells(const Box4& where, float edge) {
  const Float4 extent = where.high - where.low;
  edge = std::max(edge, std::numeric_limits<float>::min());
  constexpr float kALittle = 1.125f;
  const auto cells_on = [&](int axis) { return std::floor(double{extent[axis] / edge}) + 1; };
  while (cells_on(0) > kMaxInRow || cells_on(1) * cells_on(2) > kMaxRows) edge *= kALittle;
  for (int axis = 0; axis < 3; ++axis) sizes_[axis] = static_cast<std::uint32_t>(cells_on(axis));
  grid_ = CellGrid(where.low, edge, {sizes_[0] - 1, sizes_[1] - 1, sizes_[2] - 1});
}

void CommonCells::mark(std::span<const NumberedBox> boxes, std::vector<CellRange>& cells,
                       Rows& marked) const {
  cells.clear();
  marked.assign(std::size_t{sizes_[1]} * sizes_[2], 0);
  for (const NumberedBox& box : boxes) {
    cells.push_back(grid_.cells_of(box.box()));
    if (is_large(cells.back())) continue;
    visit_rows(cells.back(), [&](std::uint32_t row, std::uint64_t bits, std::uint32_t,
                                 std::uint32_t) { marked[row] |= bits; });
  }
}

void CommonCells::number_common_cells() {
  std::uint32_t count = 0;
  first_number_.clear();
  for (const std::uint64_t row : common_) {
    first_number_.push_back(count);
    count += static_cast<std::uint32_t>(std::popcount(row));
  }
  begin_.assign(count + 1, 0);
}

void CommonCells::sort_first_set() {
  large_.clear();
  for (std::uint32_t i = 0; i < cells_a_.size(); ++i) {
    if (is_large(cells_a_[i]))
      large_.push_back(a_[i]);
    else
      visit_common_cells(cells_a_[i], [&](const Cell&, std::uint32_t number) { ++begin_[number]; });
  }
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begin_) begin = end += begin;
  entries_.resize(end);
  // Fills each cell's entries from their end; begin_ decreases to their beginning.
  for (std::uint32_t i = 0; i < cells_a_.size(); ++i)
    if (!is_large(cells_a_[i]))
      visit_common_cells(cells_a_[i], [&](const Cell&, std::uint32_t number) {
        entries_[--begin_[number]] = a_[i];
      });
}

}  // namespace pelt::rivals
