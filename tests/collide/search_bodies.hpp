#pragma once

/// Pairs of posed bodies for tests of searches.

#include "support/pinned_shapes.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/search.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace pelt::test {

inline constexpr SearchOrder kAllOrders[] = {SearchOrder::first_contact, SearchOrder::resolution,
                                             SearchOrder::contacts};

/// Two bodies that can be posed anew.
struct SearchBodies {
  SearchBodies(Shape first, Shape second)
      : shape_a(std::move(first)),
        shape_b(std::move(second)),
        a(*build_model(shape_a.view())),
        b(*build_model(shape_b.view())) {}

  void set(std::span<const Matrix4> palette_a, std::span<const Matrix4> palette_b) {
    ASSERT_TRUE(a.set_palette(palette_a));
    ASSERT_TRUE(b.set_palette(palette_b));
  }

  Shape shape_a, shape_b;
  Pose a, b;
  Scratch scratch;
};

/// Calls `body(bodies)` for limbs in several poses, and for soups of this size.
template <typename Body>
void for_search_bodies(Random& random, int rounds, std::uint32_t soup_triangles, const Body& body) {
  SearchBodies limbs(make_limb(24, 10, 5), make_limb(17, 9, 4));
  for (int round = 0; round < rounds; ++round) {
    const Vec3 place = random.point(0.3);
    const auto bent = bend_limb(random, 4, random.uniform(-0.6, 0.6), place);
    limbs.set(bend_limb(random, 5, random.uniform(-0.6, 0.6), {}), bent);
    body(limbs);
  }
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (const Weights weights : {Weights::random, Weights::adversarial}) {
      SearchBodies soups(make_soup(random, soup_triangles, 6, 4, weights),
                         make_soup(random, soup_triangles, 5, 4, weights));
      const auto palette = make_palette(random, 6, motion, 1);
      soups.set(palette, make_palette(random, 5, motion, 1));
      body(soups);
    }
}

/// A square sheet of `cells` x `cells` cells in which each vertex can be posed freely. `height(x,
/// y)` is the z of a vertex.
template <typename Height>
std::vector<Vec3> sheet_positions(std::uint32_t cells, const Height& height) {
  std::vector<Vec3> positions;
  for (std::uint32_t y = 0; y <= cells; ++y)
    for (std::uint32_t x = 0; x <= cells; ++x)
      positions.push_back({static_cast<float>(x), static_cast<float>(y), height(x, y)});
  return positions;
}

inline Shape make_sheet(std::uint32_t cells) {
  std::vector<Triangle> triangles;
  const std::uint32_t row = cells + 1;
  for (std::uint32_t y = 0; y < cells; ++y)
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t v = y * row + x;
      triangles.push_back({v, v + 1, v + row});
      triangles.push_back({v + 1, v + row + 1, v + row});
    }
  return make_pinned(row * row, triangles);
}

}  // namespace pelt::test
