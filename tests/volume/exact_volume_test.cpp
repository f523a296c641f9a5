/// Volumes against rational numbers, on closed surfaces that are as degenerate as possible.

#include <pelt/inside.hpp>

#include "exact/predicates.hpp"
#include "support/instruction_sets.hpp"
#include "support/pinned_shapes.hpp"
#include "support/random.hpp"
#include "volume/perturbed_points.hpp"
#include "volume/prism_volume.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

namespace pelt::test {
namespace {

using ExactVolume = PrismVolume<mpq_class>;

/// A closed surface with freely chosen posed vertices.
class Body {
 public:
  Body(const std::vector<Triangle>& triangles, std::uint32_t vertex_count)
      : Body(triangles, make_pinned(vertex_count, triangles)) {}

  /// `pinned`: of `make_pinned`, perhaps with other rest positions.
  Body(const std::vector<Triangle>& triangles, const Shape& pinned)
      : triangles_(triangles),
        vertex_count_(static_cast<std::uint32_t>(pinned.rest_positions.size())),
        pose_(*build_model(pinned.view())) {
    EXPECT_TRUE(pose_.model().surface().is_closed());
  }

  void set(const std::vector<Vec3>& positions) {
    ASSERT_TRUE(pose_.set_palette(pin(positions)));
    positions_ = positions;
  }

  ExactVolume exact() const { return {positions_, triangles_}; }
  std::uint32_t vertex_count() const { return vertex_count_; }
  const std::vector<Vec3>& positions() const { return positions_; }
  Pose& pose() { return pose_; }

 private:
  std::vector<Triangle> triangles_;
  std::uint32_t vertex_count_;
  Pose pose_;
  std::vector<Vec3> positions_;
};

Volume intersection_of(Body& a, Body& b) {
  Scratch scratch;
  Volume result;
  intersection_volume(a.pose(), b.pose(), scratch, result);
  return result;
}

/// Checks the stated error, and that it is small.
void check(const Volume& found, const mpq_class& exact, double unit) {
  const mpq_class off = abs(mpq_class(found.value) - exact);
  EXPECT_LE(off, mpq_class(found.error)) << found.value << " instead of " << exact.get_d();
  EXPECT_LE(found.error, 0x1p-40 * unit);
}

/// The kind of coordinates.
enum class Numbers { grid, fine_grid, any, nearly_flat };

float coordinate(Random& random, Numbers numbers) {
  if (numbers == Numbers::grid) return static_cast<float>(random.index(4));
  if (numbers == Numbers::fine_grid) return static_cast<float>(random.index(20)) / 4;
  return random.uniformf(-1, 1);
}

Vec3 point_of(Random& random, Numbers numbers) {
  Vec3 p = {coordinate(random, numbers), coordinate(random, numbers), coordinate(random, numbers)};
  if (numbers == Numbers::nearly_flat) p.z *= 0x1p-24f;
  return p;
}

/// Some vertices coincide with others of this body, or of the other one.
std::vector<Vec3> positions_of(Random& random, Numbers numbers, std::uint32_t count,
                               const std::vector<Vec3>& other) {
  std::vector<Vec3> positions;
  for (std::uint32_t v = 0; v < count; ++v) {
    const bool is_shared = !other.empty() && random.chance(0.15);
    positions.push_back(is_shared ? other[random.index(static_cast<std::uint32_t>(other.size()))]
                        : v > 0 && random.chance(0.05) ? positions[random.index(v)]
                                                       : point_of(random, numbers));
  }
  return positions;
}

struct Hits {
  int volumes = 0, touches = 0;
};

Hits compare(Random& random, Body& a, Body& b, Numbers numbers, int rounds) {
  Hits hits;
  for (int i = 0; i < rounds; ++i) {
    a.set(positions_of(random, numbers, a.vertex_count(), {}));
    b.set(positions_of(random, numbers, b.vertex_count(), a.positions()));
    const mpq_class exact = a.exact().of_intersection(b.exact());
    check(intersection_of(a, b), exact, 1000);
    check(intersection_of(b, a), exact, 1000);
    Scratch scratch;
    hits.volumes += exact != 0;
    hits.touches += exact == 0 && intersects(a.pose(), b.pose(), scratch);
  }
  std::cout << hits.volumes << " of " << rounds << " intersect, " << hits.touches
            << " touch without a volume\n";
  return hits;
}

void compare_all(Body a, Body b, int rounds) {
  Random random(31 + a.vertex_count() + b.vertex_count());
  for (const Numbers numbers :
       {Numbers::grid, Numbers::fine_grid, Numbers::any, Numbers::nearly_flat}) {
    const Hits hits = compare(random, a, b, numbers, rounds);
    EXPECT_GT(hits.volumes, rounds / 4);
    if (numbers == Numbers::grid && a.vertex_count() < 10) {
      EXPECT_GT(hits.touches, rounds / 20);
    }
  }
}

TEST(IntersectionVolume, IsExactForTetrahedra) {
  compare_all({tetrahedron(), 4}, {tetrahedron(), 4}, 200);
}

TEST(IntersectionVolume, IsExactForOctahedra) {
  compare_all({octahedron(), 6}, {octahedron(), 6}, 60);
}

TEST(IntersectionVolume, IsExactForTori) { compare_all({torus(5, 4), 20}, {torus(4, 4), 16}, 2); }

TEST(IntersectionVolume, IsExactOnEachInstructionSet) {
  on_each_instruction_set([](InstructionSet) {
    compare_all({octahedron(), 6}, {tetrahedron(), 4}, 20);
  });
}

/// The integral of w (w - 1) / 2.
mpq_class exact_self_intersection(const Body& body, const Body& all) {
  return (body.exact().of_intersection(body.exact()) - body.exact().of_intersection(all.exact())) /
         2;
}

/// An octahedron around everything.
Body around_all() {
  Body all(octahedron(), 6);
  all.set({{99, 0, 0}, {-99, 0, 0}, {0, 99, 0}, {0, -99, 0}, {0, 0, 99}, {0, 0, -99}});
  return all;
}

void compare_self_intersections(Body body, int rounds) {
  Random random(33 + body.vertex_count());
  const Body all = around_all();
  int hits = 0;
  for (const Numbers numbers :
       {Numbers::grid, Numbers::fine_grid, Numbers::any, Numbers::nearly_flat})
    for (int i = 0; i < rounds; ++i) {
      body.set(positions_of(random, numbers, body.vertex_count(), {}));
      const mpq_class exact = exact_self_intersection(body, all);
      Scratch scratch;
      Volume found;
      self_intersection_volume(body.pose(), scratch, found);
      check(found, exact, 1000);
      hits += exact != 0;
    }
  EXPECT_GT(hits, rounds);
}

TEST(SelfIntersectionVolume, IsExactForTetrahedra) {
  compare_self_intersections({tetrahedron(), 4}, 50);
}

TEST(SelfIntersectionVolume, IsExactForOctahedra) {
  compare_self_intersections({octahedron(), 6}, 20);
}

TEST(SelfIntersectionVolume, IsExactForTori) { compare_self_intersections({torus(5, 4), 20}, 2); }

/// Adds triangles whose vertices are numbered from `first` on.
std::vector<Triangle> with(std::vector<Triangle> triangles, std::uint32_t first,
                           const std::vector<Triangle>& added) {
  for (const Triangle& t : added) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return triangles;
}

TEST(SelfIntersectionVolume, IsExactForSeparateParts) {
  compare_self_intersections({with(octahedron(), 6, tetrahedron()), 10}, 20);
}

TEST(SelfIntersectionVolume, IsExactForPartsThatShareAVertex) {
  compare_self_intersections({with(tetrahedron(), 3, tetrahedron()), 7}, 30);
}

TEST(SelfIntersectionVolume, IsExactForTrianglesWithTheSameVertices) {
  const std::vector<Triangle> both_sides = {{0, 1, 2}, {0, 2, 1}};
  compare_self_intersections({with(both_sides, 2, octahedron()), 8}, 20);
}

TEST(SelfIntersectionVolume, IgnoresTrianglesWithRepeatedVertices) {
  compare_self_intersections({with({{0, 0, 1}, {2, 2, 2}}, 0, octahedron()), 6}, 20);
}

/// Vertices with one rest position and different influences are one surface vertex to
/// self-collision.
TEST(SelfIntersectionVolume, IsExactForSplitSurfaceVertices) {
  for (const std::uint32_t distinct : {1u, 3u}) {
    Shape pinned = make_pinned(6, octahedron());
    for (std::uint32_t v = distinct; v < 6; ++v)
      pinned.rest_positions[v] = pinned.rest_positions[v % distinct];
    compare_self_intersections({octahedron(), pinned}, 60);
  }
}

TEST(SelfIntersectionVolume, IsExactOnEachInstructionSet) {
  on_each_instruction_set([](InstructionSet) { compare_self_intersections({octahedron(), 6}, 5); });
}

TEST(Volume, IsExactForTori) {
  Random random(32);
  Body body(torus(5, 4), 20);
  const Body all = around_all();
  for (int i = 0; i < 20; ++i) {
    body.set(positions_of(random, i % 2 == 0 ? Numbers::grid : Numbers::any, 20, {}));
    Volume found;
    volume(body.pose(), found);
    check(found, body.exact().of_intersection(all.exact()), 1);
  }
}

}  // namespace
}  // namespace pelt::test

// Decisions about points in general position, against the same points moved by a small number e
// that is written out: 2^-32, whose powers are distinct from each other by far more than the
// coefficients of any term.
namespace pelt::detail {
namespace {

using test::Random;
using Moved = std::array<mpz_class, 3>;

/// Points numbered below `count`, in units that make moved coordinates whole.
class MovedPoints {
 public:
  explicit MovedPoints(std::uint32_t count) : bits_(32ul << (3 * count - 1)) {}

  Moved operator()(const NumberedPoint& p) const {
    return {moved(p.at.x, 3 * p.number), moved(p.at.y, 3 * p.number + 1),
            moved(p.at.z, 3 * p.number + 2)};
  }

 private:
  mpz_class moved(float coordinate, std::uint32_t exponent) const {
    mpz_class whole(static_cast<double>(coordinate)), step(1);
    whole <<= bits_;
    step <<= bits_ - (32ul << exponent);
    return whole + step;
  }

  unsigned long bits_;
};

Moved difference(const Moved& a, const Moved& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

mpz_class height(const MovedPoints& moved, const NumberedTriangle& plane, const NumberedPoint& p) {
  const Moved origin = moved(plane[0]);
  const Moved u = difference(moved(plane[1]), origin), v = difference(moved(plane[2]), origin),
              w = difference(moved(p), origin);
  return mpz_class((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
                   (u[0] * v[1] - u[1] * v[0]) * w[2]);
}

/// Points of a small grid with shuffled numbers. Some coincide.
std::vector<NumberedPoint> points_of(Random& random, std::uint32_t count) {
  std::vector<NumberedPoint> points(count);
  const auto coordinate = [&] { return static_cast<float>(random.index(3)); };
  for (std::uint32_t i = 0; i < count; ++i) {
    points[i] = {{coordinate(), coordinate(), coordinate()}, i};
    std::swap(points[i].number, points[random.index(i + 1)].number);
  }
  return points;
}

TEST(PerturbedPoints, AreOnTheSideOfThePlaneOnWhichTheMovedPointsAre) {
  Random random(61);
  const MovedPoints moved(4);
  int flat = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto p = points_of(random, 4);
    const NumberedTriangle plane = {p[0], p[1], p[2]};
    ASSERT_EQ(perturbed_side(plane, p[3]), sgn(height(moved, plane, p[3])));
    flat += orient3d(p[0].at, p[1].at, p[2].at, p[3].at) == 0;
  }
  EXPECT_GT(flat, 250);
}

TEST(PerturbedPoints, FaceWhereTheMovedTriangleFaces) {
  Random random(62);
  const MovedPoints moved(3);
  int flat = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto p = points_of(random, 3);
    const Moved u = difference(moved(p[1]), moved(p[0])), v = difference(moved(p[2]), moved(p[0]));
    ASSERT_EQ(perturbed_facing({p[0], p[1], p[2]}), sgn(mpz_class(u[1] * v[2] - u[2] * v[1])));
    flat += orient2d(without(p[0].at, 0), without(p[1].at, 0), without(p[2].at, 0)) == 0;
  }
  EXPECT_GT(flat, 800);
}

TEST(PerturbedPoints, CrossAPlaneWhereTheMovedEdgeDoes) {
  Random random(63);
  const MovedPoints moved(5);
  int crossings = 0, flat = 0;
  for (int i = 0; i < 150; ++i) {
    const auto p = points_of(random, 5);
    const NumberedTriangle plane = {p[0], p[1], p[2]};
    if (perturbed_side(plane, p[3]) == perturbed_side(plane, p[4])) continue;
    const mpz_class from = height(moved, plane, p[3]), to = height(moved, plane, p[4]);
    const Rounded share = perturbed_share(plane, p[3], p[4]);
    const mpq_class expected(abs(from), abs(from) + abs(to));
    ASSERT_NEAR(share.value(), expected.get_d(), 1e-6);
    ASSERT_LT(share.error(), 1e-12);
    ++crossings;
    flat += orient3d(p[0].at, p[1].at, p[2].at, p[3].at) == 0 &&
            orient3d(p[0].at, p[1].at, p[2].at, p[4].at) == 0;
  }
  EXPECT_GT(crossings, 50);
  EXPECT_GT(flat, 8);
}

}  // namespace
}  // namespace pelt::detail
