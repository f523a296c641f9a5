#include "field/height_field.hpp"

#include "base/assert.hpp"
#include "base/problem.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pelt {
namespace detail {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Problem check_sizes(const HeightGrid& grid) {
  if (grid.columns < 2 || grid.rows < 2)
    return problem("the height field has %u columns and %u rows, expected 2 or more of each",
                   grid.columns, grid.rows);
  const std::uint64_t cells = std::uint64_t{grid.columns - 1} * (grid.rows - 1);
  if (cells > 0x7FFFFFFF)
    return problem("a height field of %u columns and %u rows has more than 2^32 - 2 triangles",
                   grid.columns, grid.rows);
  const std::uint64_t expected = std::uint64_t{grid.columns} * grid.rows;
  if (grid.heights.size() != expected)
    return problem("heights has %zu elements, expected %llu (rows x columns)", grid.heights.size(),
                   static_cast<unsigned long long>(expected));
  return {};
}

Problem check_spacing(const char* name, float spacing) {
  if (spacing > 0 && std::isfinite(spacing)) return {};
  return problem("%s is %g, expected a positive number", name, static_cast<double>(spacing));
}

/// `place` is the coordinate of all vertices of column or row `index`.
Problem check_place(const char* name, std::size_t index, float place) {
  if (std::fabs(place) <= kMaxCoordinate) return {};
  return problem("%s %zu of the height field is at %g, expected finite and within 2^60", name,
                 index, static_cast<double>(place));
}

Problem check_places(const char* name, const std::vector<float>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (Problem found = check_place(name, i, places[i]); !found.empty()) return found;
    if (i > 0 && !(places[i - 1] < places[i]))
      return problem(
          "%ss %zu and %zu of the height field are both at %g: this far from the origin "
          "their spacing must be larger",
          name, i - 1, i, static_cast<double>(places[i]));
  }
  return {};
}

Problem check_heights(const HeightGrid& grid, const std::vector<float>& y) {
  for (std::size_t i = 0; i < y.size(); ++i)
    if (!std::isnan(grid.heights[i]) && !(std::fabs(y[i]) <= kMaxCoordinate))
      return problem("heights[%zu] is %g, expected NaN (a hole) or within 2^60 of the origin's y",
                     i, static_cast<double>(grid.heights[i]));
  return {};
}

std::vector<float> places_of(float origin, float spacing, std::uint32_t count) {
  std::vector<float> places(count);
  for (std::uint32_t i = 0; i < count; ++i)
    places[i] = static_cast<float>(double{origin} + double{spacing} * i);
  return places;
}

std::vector<float> heights_of(const HeightGrid& grid) {
  std::vector<float> y(grid.heights.size());
  std::transform(grid.heights.begin(), grid.heights.end(), y.begin(), [&](float height) {
    return static_cast<float>(double{grid.origin.y} + double{height});
  });
  return y;
}

/// Ignores NaN, because comparisons with NaN are false.
void include(float height, HeightRange& range) {
  if (height < range.low) range.low = height;
  if (height > range.high) range.high = height;
}

std::uint32_t blocks_of(std::uint32_t count, std::uint32_t shift) {
  return ((count - 1) >> shift) + 1;
}

/// Vertices on the border of blocks belong to all of them.
HeightRange range_of_cells(const HeightField& field, std::uint32_t column, std::uint32_t row) {
  constexpr std::uint32_t kSide = 1u << kBlockShift;
  HeightRange range = {kInfinity, -kInfinity};
  for (std::uint32_t r = row * kSide; r <= std::min((row + 1) * kSide, field.rows() - 1); ++r)
    for (std::uint32_t c = column * kSide; c <= std::min((column + 1) * kSide, field.columns() - 1);
         ++c)
      include(field.y[std::size_t{r} * field.columns() + c], range);
  return range;
}

HeightRange range_of_blocks(const FieldLevel& below, std::uint32_t column, std::uint32_t row) {
  HeightRange range = {kInfinity, -kInfinity};
  for (std::uint32_t r = 2 * row; r < std::min(2 * row + 2, below.rows); ++r)
    for (std::uint32_t c = 2 * column; c < std::min(2 * column + 2, below.columns); ++c) {
      const HeightRange& block = below.blocks[std::size_t{r} * below.columns + c];
      include(block.low, range);
      include(block.high, range);
    }
  return range;
}

/// `range(column, row)` has the heights of a block.
template <typename Range>
FieldLevel make_level(std::uint32_t columns, std::uint32_t rows, const Range& range) {
  FieldLevel level = {columns, rows, {}};
  level.blocks.reserve(std::size_t{columns} * rows);
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      level.blocks.push_back(range(column, row));
  return level;
}

void build_levels(HeightField& field) {
  field.levels.push_back(make_level(
      blocks_of(field.columns() - 1, kBlockShift), blocks_of(field.rows() - 1, kBlockShift),
      [&](std::uint32_t column, std::uint32_t row) { return range_of_cells(field, column, row); }));
  while (field.levels.back().blocks.size() > 1) {
    const FieldLevel& below = field.levels.back();
    FieldLevel level = make_level(blocks_of(below.columns, 1), blocks_of(below.rows, 1),
                                  [&](std::uint32_t column, std::uint32_t row) {
                                    return range_of_blocks(below, column, row);
                                  });
    field.levels.push_back(std::move(level));
  }
}

Problem check_and_fill(const HeightGrid& grid, HeightField& field) {
  if (Problem found = check_sizes(grid); !found.empty()) return found;
  if (Problem found = check_spacing("column_spacing", grid.column_spacing); !found.empty())
    return found;
  if (Problem found = check_spacing("row_spacing", grid.row_spacing); !found.empty()) return found;
  field.x = places_of(grid.origin.x, grid.column_spacing, grid.columns);
  field.z = places_of(grid.origin.z, grid.row_spacing, grid.rows);
  field.y = heights_of(grid);
  field.columns_per_x = 1 / grid.column_spacing;
  field.rows_per_z = 1 / grid.row_spacing;
  if (Problem found = check_places("column", field.x); !found.empty()) return found;
  if (Problem found = check_places("row", field.z); !found.empty()) return found;
  return check_heights(grid, field.y);
}

}  // namespace

std::array<Vec3, 3> HeightField::triangle(std::uint32_t number) const {
  const std::uint32_t cell = number / 2, column = cell % (columns() - 1);
  const std::uint32_t row = cell / (columns() - 1);
  const auto vertex = [&](std::uint32_t c, std::uint32_t r) {
    return Vec3{x[c], y[std::size_t{r} * columns() + c], z[r]};
  };
  const Vec3 first = vertex(column, row), last = vertex(column + 1, row + 1);
  if (number % 2 == 0) return {first, vertex(column, row + 1), last};
  return {first, last, vertex(column + 1, row)};
}

}  // namespace detail

HeightField::HeightField(std::shared_ptr<const detail::HeightField> field)
    : field_(std::move(field)) {}

std::uint32_t HeightField::columns() const { return field_->columns(); }
std::uint32_t HeightField::rows() const { return field_->rows(); }

std::uint32_t HeightField::triangle_count() const { return 2 * (columns() - 1) * (rows() - 1); }

std::array<Vec3, 3> HeightField::triangle(std::uint32_t triangle) const {
  PELT_ASSERT(triangle < triangle_count());
  return field_->triangle(triangle);
}

Result<HeightField> build_height_field(const HeightGrid& grid) {
  auto field = std::make_shared<detail::HeightField>();
  if (detail::Problem found = detail::check_and_fill(grid, *field); !found.empty())
    return detail::invalid_argument(std::move(found));
  detail::build_levels(*field);
  return HeightField(std::move(field));
}

}  // namespace pelt
