#include "fields.hpp"

#include <limits>
#include <string>

namespace pelt {
namespace {

using test::make_plain;
using test::Terrain;

TEST(HeightField, VerticesAreWhereTheGridSays) {
  Terrain terrain = make_plain(4, 3, {10, 100, -20}, 0.5f);
  terrain.grid.row_spacing = 2;
  for (std::size_t i = 0; i < terrain.heights.size(); ++i)
    terrain.heights[i] = static_cast<float>(i);
  const HeightField field = terrain.build();
  EXPECT_EQ(field.columns(), 4u);
  EXPECT_EQ(field.rows(), 3u);
  EXPECT_EQ(field.triangle_count(), 12u);
  // The cell in column 2 of row 1.
  const Vec3 first = {11, 106, -18}, across = {11.5f, 111, -16};
  EXPECT_EQ(field.triangle(10), (std::array<Vec3, 3>{first, Vec3{11, 110, -16}, across}));
  EXPECT_EQ(field.triangle(11), (std::array<Vec3, 3>{first, across, Vec3{11.5f, 107, -18}}));
}

TEST(HeightField, FrontsAreAbove) {
  const HeightField field = make_plain(2, 2, {}, 1).build();
  for (std::uint32_t t = 0; t < 2; ++t) {
    const auto [a, b, c] = field.triangle(t);
    EXPECT_GT((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z), 0);
  }
}

TEST(HeightField, RefusesWhatBreaksARule) {
  const auto message = [](Terrain terrain) {
    terrain.grid.heights = terrain.heights;
    const Result<HeightField> result = build_height_field(terrain.grid);
    return result ? std::string() : result.error().message;
  };
  Terrain terrain = make_plain(3, 2, {}, 1);
  EXPECT_EQ(message(terrain), "");

  terrain.grid.rows = 1;
  EXPECT_EQ(message(terrain),
            "the height field has 3 columns and 1 rows, expected 2 or more of each");
  terrain.grid.rows = 3;
  EXPECT_EQ(message(terrain), "heights has 6 elements, expected 9 (rows x columns)");
  terrain.grid.rows = 1u << 31;
  EXPECT_EQ(message(terrain),
            "a height field of 3 columns and 2147483648 rows has more than 2^32 - 2 triangles");

  terrain = make_plain(3, 2, {}, 1);
  terrain.grid.row_spacing = 0;
  EXPECT_EQ(message(terrain), "row_spacing is 0, expected a positive number");
  terrain = make_plain(3, 2, {}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(message(terrain), "column_spacing is nan, expected a positive number");
  terrain = make_plain(3, 2, {}, 0x1p60f);
  EXPECT_EQ(message(terrain),
            "column 2 of the height field is at 2.30584e+18, expected finite and within 2^60");
  terrain = make_plain(3, 2, {0x1p25f, 0, 0}, 1);
  EXPECT_EQ(message(terrain),
            "columns 0 and 1 of the height field are both at 3.35544e+07: this far from the origin "
            "their spacing must be larger");

  terrain = make_plain(3, 2, {}, 1);
  terrain.heights[4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(message(terrain),
            "heights[4] is inf, expected NaN (a hole) or within 2^60 of the origin's y");
  terrain.heights[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(message(terrain), "");
}

}  // namespace
}  // namespace pelt
