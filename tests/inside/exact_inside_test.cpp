/// side_of and winding_number against integer arithmetic, on closed surfaces that are as degenerate
/// as possible.

#include <pelt/inside.hpp>

#include "support/exact_winding.hpp"
#include "support/instruction_sets.hpp"
#include "support/pinned_shapes.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

namespace pelt::test {
namespace {

/// A closed surface with freely chosen posed vertices.
class Body {
 public:
  explicit Body(const std::vector<Triangle>& triangles, std::uint32_t vertex_count)
      : triangles_(triangles), pose_(*build_model(make_pinned(vertex_count, triangles).view())) {
    EXPECT_TRUE(pose_.model().surface().is_closed());
  }

  void set(const std::vector<Vec3>& positions) {
    ASSERT_TRUE(pose_.set_palette(pin(positions)));
    std::vector<Vec3> posed(positions.size());
    posed_vertices(pose_, posed);
    ASSERT_EQ(posed, positions);
    positions_ = positions;
  }

  PointSide side_of(const Vec3& point) { return point_side(pose_, point, scratch_); }

  std::int32_t winding_number(const Vec3& point) {
    std::int32_t result = 77;
    pelt::winding_number(pose_, point, scratch_, result);
    return result;
  }

  PointSide expected(const Vec3& point) const {
    return ExactWinding(positions_, triangles_).side_of(point);
  }

  std::optional<int> expected_winding(const Vec3& point) const {
    return ExactWinding(positions_, triangles_).winding_number(point);
  }

 private:
  std::vector<Triangle> triangles_;
  Pose pose_;
  Scratch scratch_;
  std::vector<Vec3> positions_;
};

PointSide side_of_tetrahedron(const std::vector<Vec3>& corners, const Vec3& point) {
  Body body(tetrahedron(), 4);
  body.set(corners);
  const PointSide side = body.side_of(point);
  EXPECT_EQ(side, body.expected(point));
  return side;
}

TEST(SideOfCollapsedBody, IsOnItsPointsAndSegments) {
  EXPECT_EQ(side_of_tetrahedron({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {1, 1, 1}),
            PointSide::on);
  const std::vector<Vec3> segment = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(side_of_tetrahedron(segment, {1, 0, 0}), PointSide::on);
  EXPECT_EQ(side_of_tetrahedron(segment, {2.5f, 0, 0}), PointSide::on);
  EXPECT_EQ(side_of_tetrahedron(segment, {2.5f, 0x1p-149f, 0}), PointSide::outside);
  EXPECT_EQ(side_of_tetrahedron(segment, {std::nextafter(3.0f, 4.0f), 0, 0}), PointSide::outside);
}

TEST(SideOf, IsNotOnAFaceWhoseDistanceUnderflows) {
  const auto beside = [](float height) {
    return side_of_tetrahedron({{0, 0, 0}, {1, 0, height}, {0, 1, 0}, {0, 0, 1}},
                               {0x1p-30f, 0x1p-30f, 0});
  };
  EXPECT_EQ(beside(0x1p-126f), PointSide::outside);  // by 2^-156
  EXPECT_EQ(beside(0x1p-101f), PointSide::outside);
  EXPECT_EQ(beside(0), PointSide::on);
  EXPECT_EQ(beside(-0x1p-126f), PointSide::inside);
}

TEST(SideOf, ReturnsWhereWeightsUnderflow) {
  EXPECT_EQ(side_of_tetrahedron({{-1, 0, 0}, {1, 0, 0}, {0, 0x1p59f, 4}, {0, 0x1p59f, -4}},
                                {0, 0x1p-92f, 0}),
            PointSide::inside);
  EXPECT_EQ(side_of_tetrahedron({{-1, 0, 0}, {1, 0, 0}, {0, 0x1p59f, 4}, {0, 0x1p59f, -4}},
                                {0, -0x1p-92f, 0}),
            PointSide::outside);
  side_of_tetrahedron({{0x1.c1c1c2p+56f, 0, 0x1.f4p+9f},
                       {0x1.00015cp-75f, 0x1.313132p+54f, 0x1.f4p+11f},
                       {0, 0x1p-75f, -0x1.77p+11f},
                       {0x1p-75f, 0x1p-75f, 0x1.f4p+11f}},
                      {0x1.c1c1c2p+55f, 0x1.313132p+53f, 0x1.388p+11f});
}

/// The ray along the first generic direction hits a vertex, an edge or a face.
TEST(SideOf, NeedsNoSecondRay) {
  const auto on_ray = [](float t) { return Vec3{t * 0.8391f, t * 0.4772f, t * 0.2613f}; };
  const Vec3 a = {-4, 0, 1}, b = {-4, -3, -1}, c = {0, 3, -4};
  EXPECT_EQ(side_of_tetrahedron({on_ray(2), a, b, c}, {0, 0, 0}), PointSide::inside);
  EXPECT_EQ(side_of_tetrahedron({on_ray(2), a, b, c}, on_ray(-16)), PointSide::outside);
  EXPECT_EQ(side_of_tetrahedron({on_ray(2), on_ray(4), a, b}, {0, 0, 0}), PointSide::outside);
  EXPECT_EQ(side_of_tetrahedron({on_ray(-2), on_ray(4), a, b}, on_ray(-4)), PointSide::outside);
  EXPECT_EQ(side_of_tetrahedron({on_ray(-2), on_ray(4), a, b}, {0, 0, 0}), PointSide::on);
}

/// The kind of coordinates.
enum class Numbers { grid, few, wide };

float coordinate(Random& random, Numbers numbers) {
  constexpr std::array kFew = {0.0f,     -0.0f,     0x1p-149f, -0x1p-149f, 0x1p-126f,
                               0x1p-75f, -0x1p-75f, 1.0f,      -1.0f,      0x1.000002p+0f,
                               0x1p-25f, 3e9f,      0x1p58f,   -0x1p58f,   -0x1p59f};
  switch (numbers) {
    case Numbers::grid:
      return static_cast<float>(static_cast<int>(random.index(5)) - 2);
    case Numbers::few:
      return kFew[random.index(kFew.size())];
    case Numbers::wide:
      return std::ldexp(random.uniformf(-1, 1), static_cast<int>(random.index(200)) - 141);
  }
  return 0;
}

Vec3 point_of(Random& random, Numbers numbers) {
  return {coordinate(random, numbers), coordinate(random, numbers), coordinate(random, numbers)};
}

/// A point halfway, a third or two thirds of the way between two vertices, or anywhere.
Vec3 question(Random& random, Numbers numbers, const std::vector<Vec3>& posed) {
  if (random.chance(0.2)) return point_of(random, numbers);
  const auto any = [&] { return posed[random.index(static_cast<std::uint32_t>(posed.size()))]; };
  const Vec3 a = any(), b = any(), c = any(), d = any();
  if (random.chance(0.3)) return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  return {a.x / 4 + b.x / 4 + c.x / 4 + d.x / 4, a.y / 4 + b.y / 4 + c.y / 4 + d.y / 4,
          a.z / 4 + b.z / 4 + c.z / 4 + d.z / 4};
}

struct Counts {
  int on = 0, inside = 0, outside = 0;
  int several = 0;  // enclosed more than once, or inside out
};

Counts compare(Random& random, Body& body, std::uint32_t vertex_count, Numbers numbers,
               int rounds) {
  Counts counts;
  for (int i = 0; i < rounds; ++i) {
    std::vector<Vec3> positions;
    for (std::uint32_t v = 0; v < vertex_count; ++v)
      positions.push_back(v > 0 && random.chance(0.1) ? positions[random.index(v)]
                                                      : point_of(random, numbers));
    body.set(positions);
    for (int j = 0; j < 5; ++j) {
      const Vec3 point = question(random, numbers, positions);
      const std::optional<int> winding = body.expected_winding(point);
      const PointSide expected = !winding        ? PointSide::on
                                 : *winding != 0 ? PointSide::inside
                                                 : PointSide::outside;
      EXPECT_EQ(body.side_of(point), expected) << point.x << ' ' << point.y << ' ' << point.z;
      EXPECT_EQ(body.winding_number(point), winding.value_or(0));
      counts.several += winding && (*winding < 0 || *winding > 1);
      counts.on += expected == PointSide::on;
      counts.inside += expected == PointSide::inside;
      counts.outside += expected == PointSide::outside;
    }
  }
  std::cout << counts.on << " on, " << counts.inside << " inside, " << counts.outside
            << " outside\n";
  return counts;
}

void compare_all(const std::vector<Triangle>& triangles, std::uint32_t vertex_count, int rounds) {
  Random random(21 + vertex_count);
  Body body(triangles, vertex_count);
  for (const Numbers numbers : {Numbers::grid, Numbers::few, Numbers::wide}) {
    const Counts counts = compare(random, body, vertex_count, numbers, rounds);
    EXPECT_GT(counts.on, rounds / 20);
    EXPECT_GT(counts.outside, rounds / 2);
    EXPECT_GT(counts.inside, rounds / 20);
    EXPECT_GT(counts.several, rounds / 40);
  }
}

TEST(SideOf, IsExactForTetrahedra) { compare_all(tetrahedron(), 4, 600); }
TEST(SideOf, IsExactForOctahedra) { compare_all(octahedron(), 6, 300); }
TEST(SideOf, IsExactForTori) { compare_all(torus(5, 4), 20, 80); }

TEST(SideOf, IsTheSameOnEveryTarget) {
  on_each_instruction_set([](InstructionSet) { compare_all(octahedron(), 6, 40); });
}

}  // namespace
}  // namespace pelt::test
