#pragma once

/// Height fields for tests, and brute force over their triangles.

#include "geometry/triangle_pair.hpp"
#include "support/random.hpp"

#include <pelt/height_field.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::test {

/// The arrays behind a HeightGrid.
struct Terrain {
  std::vector<float> heights;
  HeightGrid grid;

  HeightField build() const {
    HeightGrid view = grid;
    view.heights = heights;
    return *build_height_field(view);
  }
};

/// All heights zero.
inline Terrain make_plain(std::uint32_t columns, std::uint32_t rows, const Vec3& origin,
                          float spacing) {
  return {std::vector<float>(std::size_t{columns} * rows),
          {{}, columns, rows, origin, spacing, spacing}};
}

/// Waves and noise with a fraction of holes.
inline Terrain make_hills(Random& random, std::uint32_t columns, std::uint32_t rows,
                          const Vec3& origin, float spacing, double height, double holes) {
  Terrain terrain = make_plain(columns, rows, origin, spacing);
  const double turn = random.uniform(0.1, 0.7), shift = random.uniform(0, 6);
  for (std::size_t i = 0; i < terrain.heights.size(); ++i) {
    const double wave = std::sin(turn * static_cast<double>(i % columns) + shift) +
                        std::cos(turn * static_cast<double>(i / columns));
    const double noise = random.uniform(-0.3, 0.3);
    terrain.heights[i] =
        random.chance(holes) ? NAN : static_cast<float>(height * (wave / 2 + noise));
  }
  return terrain;
}

inline bool is_hole(const detail::TriangleCorners& corners) {
  return std::isnan(corners[0].y) || std::isnan(corners[1].y) || std::isnan(corners[2].y);
}

inline std::vector<Contact> brute_force(const HeightField& field,
                                        std::span<const Triangle> triangles,
                                        std::span<const Vec3> positions) {
  std::vector<Contact> contacts;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    const detail::TriangleCorners corners = {positions[a], positions[b], positions[c]};
    for (std::uint32_t f = 0; f < field.triangle_count(); ++f) {
      const detail::TriangleCorners other = field.triangle(f);
      if (!is_hole(other) && detail::triangles_intersect(corners, other))
        contacts.push_back({t, f});
    }
  }
  return contacts;
}

}  // namespace pelt::test
