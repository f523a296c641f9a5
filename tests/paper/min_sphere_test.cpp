#include "paper/min_sphere.hpp"

#include "base/vec3.hpp"
#include "geometry/triangle_cases.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <span>
#include <vector>

namespace pelt::test {
namespace {

using detail::TriangleCorners;
using paper::min_sphere;
using paper::Sphere;

using Rational3 = std::array<mpq_class, 3>;

Rational3 rational(const Vec3& p) {
  return {mpq_class(double{p.x}), mpq_class(double{p.y}), mpq_class(double{p.z})};
}

Rational3 difference(const Rational3& a, const Rational3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

mpq_class dot(const Rational3& a, const Rational3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

mpq_class squared_distance(const Rational3& a, const Rational3& b) {
  const Rational3 d = difference(a, b);
  return dot(d, d);
}

bool encloses_exactly(const Sphere& sphere, std::span<const Vec3> points) {
  const Rational3 centre = rational(sphere.centre);
  const mpq_class radius = double{sphere.radius};
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return squared_distance(rational(p), centre) <= radius * radius;
  });
}

/// Solves the symmetric system of at most three equations by elimination; nullopt if it is
/// singular.
std::optional<std::vector<mpq_class>> solve(std::vector<std::vector<mpq_class>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && rows[pivot][column] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == column) continue;
      const mpq_class factor = rows[i][column] / rows[column][column];
      for (std::size_t j = column; j <= n; ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  std::vector<mpq_class> solution;
  for (std::size_t i = 0; i < n; ++i) solution.push_back(rows[i][n] / rows[i][i]);
  return solution;
}

/// The centre of the smallest sphere through all of `support`, if they are affinely independent.
std::optional<Rational3> circumcentre(const std::vector<Rational3>& support) {
  std::vector<Rational3> edges;
  for (std::size_t i = 1; i < support.size(); ++i) {
    edges.push_back(difference(support[i], support[0]));
  }
  std::vector<std::vector<mpq_class>> rows;
  for (const Rational3& e : edges) {
    rows.emplace_back();
    for (const Rational3& f : edges) rows.back().push_back(2 * dot(e, f));
    rows.back().push_back(dot(e, e));
  }
  const auto weights = solve(rows);
  if (!weights) return std::nullopt;
  Rational3 centre = support[0];
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] += (*weights)[i] * edges[i][axis];
  }
  return centre;
}

/// The exact squared radius of the minimal enclosing sphere: the smallest of all spheres through
/// one to four of the points that enclose all points.
mpq_class exact_min_squared_radius(std::span<const Vec3> points) {
  std::vector<Rational3> all;
  for (const Vec3& p : points) all.push_back(rational(p));
  std::optional<mpq_class> best;
  for (unsigned subset = 1; subset < 1u << all.size(); ++subset) {
    std::vector<Rational3> support;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (subset >> i & 1) support.push_back(all[i]);
    }
    if (support.size() > 4) continue;
    const auto centre = circumcentre(support);
    if (!centre) continue;
    const mpq_class squared_radius = squared_distance(support[0], *centre);
    if (best && *best <= squared_radius) continue;
    if (std::all_of(all.begin(), all.end(), [&](const Rational3& p) {
          return squared_distance(p, *centre) <= squared_radius;
        })) {
      best = squared_radius;
    }
  }
  return *best;
}

/// Checks that the sphere encloses all points and is no larger than `slack` relative to the exact
/// minimum. At coordinates of size `extent`, allows for rounding the centre to float.
void expect_minimal(const Sphere& sphere, std::span<const Vec3> points, double slack) {
  ASSERT_TRUE(encloses_exactly(sphere, points));
  float extent = 0;
  for (const Vec3& p : points) {
    extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  // mpf, because a squared radius may exceed the range of double.
  const double minimum = mpf_class(sqrt(mpf_class(exact_min_squared_radius(points), 128))).get_d();
  EXPECT_LE(sphere.radius, minimum * (1 + slack) + 0x1p-23 * extent + 0x1p-147);
}

std::vector<Vec3> scaled_points(std::span<const Point> points, int exponent) {
  std::vector<Vec3> result;
  for (const Point& p : points) result.push_back(scaled({p, p, p}, exponent)[0]);
  return result;
}

std::vector<Point> uniform_points(Random& random, std::size_t count, std::int64_t low,
                                  std::int64_t high) {
  std::vector<Point> points(count);
  for (Point& p : points) p = uniform_point(random, low, high);
  return points;
}

constexpr double kMinSphereSlack = 1e-6;

/// Sets of one to seven points, at magnitudes from subnormal to 2^60.
template <typename Make>
void expect_minimal_spheres(const Make& make, std::uint64_t seed, int sets) {
  std::cout << "seed " << seed << "\n";
  Random random(seed);
  for (int i = 0; i < sets && !testing::Test::HasFatalFailure(); ++i) {
    const int exponent = std::array{-149, -24, 0, 36}[random() % 4];
    const auto points = scaled_points(make(random, 1 + random() % 7), exponent);
    SCOPED_TRACE("set " + std::to_string(i));
    expect_minimal(min_sphere(points), points, kMinSphereSlack);
  }
}

TEST(MinSphere, OfOnePointIsThePoint) {
  const std::vector<Vec3> points = {{1, -2, 3}};
  const Sphere sphere = min_sphere(points);
  EXPECT_EQ(sphere.centre, points[0]);
  EXPECT_LE(sphere.radius, 0x1p-149f);
}

TEST(MinSphere, OfTwoPointsHasThemAsDiameter) {
  const std::vector<Vec3> points = {{-1, 2, 3}, {3, 2, 3}};
  const Sphere sphere = min_sphere(points);
  EXPECT_EQ(sphere.centre, (Vec3{1, 2, 3}));
  EXPECT_NEAR(sphere.radius, 2, 1e-6);
}

TEST(MinSphere, OfCubeIsItsCircumsphere) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back({float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)});
  }
  const Sphere sphere = min_sphere(points);
  EXPECT_EQ(sphere.centre, (Vec3{0.5f, 0.5f, 0.5f}));
  EXPECT_NEAR(sphere.radius, std::sqrt(0.75), 1e-6);
}

TEST(MinSphere, IsMinimalAnywhere) {
  expect_minimal_spheres(
      [](Random& random, std::size_t n) { return uniform_points(random, n, -kLimit, kLimit); }, 51,
      800);
}

/// Has many duplicate, collinear, coplanar, cocircular and cospherical points.
TEST(MinSphere, IsMinimalOnGrid) {
  expect_minimal_spheres(
      [](Random& random, std::size_t n) { return uniform_points(random, n, 0, 3); }, 52, 800);
}

TEST(MinSphere, IsMinimalOfCollinearPoints) {
  const auto make = [](Random& random, std::size_t n) {
    const Point start = uniform_point(random, -1000, 1000), step = uniform_point(random, -99, 99);
    std::vector<Point> points(n);
    for (Point& p : points) p = start + uniform(random, -100, 100) * step;
    return points;
  };
  expect_minimal_spheres(make, 53, 400);
}

TEST(MinSphere, IsMinimalNearLinesAndPlanes) {
  const auto make = [](Random& random, std::size_t n) {
    IntegerCorners corners = uniform_corners(random, -kLimit / 4, kLimit / 4);
    if (random() % 2) corners[2] = corners[1];
    std::vector<Point> points(n);
    for (Point& p : points) p = near_plane(random, corners);
    return points;
  };
  expect_minimal_spheres(make, 54, 800);
}

TEST(MinSphere, IsMinimalNearOneSphere) {
  const auto make = [](Random& random, std::size_t n) {
    std::normal_distribution<double> gauss;
    std::vector<Point> points(n);
    for (Point& p : points) {
      const std::array d = {gauss(random), gauss(random), gauss(random)};
      const double scale = 4e6 / std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = std::llround(scale * d[axis]);
    }
    return points;
  };
  expect_minimal_spheres(make, 55, 800);
}

TEST(MinSphere, IsMinimalOfTinyClusterFarFromOrigin) {
  const auto make = [](Random& random, std::size_t n) {
    auto points = uniform_points(random, n, -2, 2);
    for (Point& p : points) p = p + Point{kLimit - 2, 2 - kLimit, kLimit / 2};
    return points;
  };
  expect_minimal_spheres(make, 56, 400);
}

TEST(MinSphere, IsMinimalOfManyPoints) {
  Random random = seeded(57);
  auto points = scaled_points(uniform_points(random, 100'000, -kLimit, kLimit), -24);
  const Sphere sphere = min_sphere(points);
  EXPECT_TRUE(encloses_exactly(sphere, points));
  // The few points on the boundary need an equally large sphere.
  const detail::Vec3d centre(sphere.centre);
  const auto farther = [&](const Vec3& p, const Vec3& q) {
    return squared_length(detail::Vec3d(p) - centre) > squared_length(detail::Vec3d(q) - centre);
  };
  std::sort(points.begin(), points.end(), farther);
  expect_minimal(sphere, std::span(points).first(7), kMinSphereSlack);
}

TEST(MinSphere, OfManyPointsOnSphereIsThatSphere) {
  Random random = seeded(58);
  std::normal_distribution<double> gauss;
  std::vector<Vec3> points;
  for (int i = 0; i < 50'000; ++i) {
    const double x = gauss(random), y = gauss(random), z = gauss(random);
    const double scale = 3 / std::sqrt(x * x + y * y + z * z);
    points.push_back({float(1 + scale * x), float(2 + scale * y), float(3 + scale * z)});
  }
  const Sphere sphere = min_sphere(points);
  EXPECT_TRUE(encloses_exactly(sphere, points));
  EXPECT_NEAR(sphere.radius, 3, 3e-6);
  EXPECT_NEAR(sphere.centre.x, 1, 1e-3);
}

TEST(MinSphere, OfManyEqualPointsIsThePoint) {
  const std::vector<Vec3> points(1000, Vec3{0.1f, 0.2f, 0.3f});
  EXPECT_LE(min_sphere(points).radius, 0x1p-149f);
}

TEST(MinSphere, IsTheSameEveryTime) {
  Random random = seeded(59);
  const auto points = scaled_points(uniform_points(random, 1000, -9, 9), 0);
  const Sphere first = min_sphere(points), second = min_sphere(points);
  EXPECT_EQ(first.centre, second.centre);
  EXPECT_EQ(first.radius, second.radius);
}

/// A vertex is farther away by less than double can represent.
TEST(MinSphere, IsMinimalOfFarPoints) {
  Random random = seeded(65);
  for (int i = 0; i < 8'000 && !HasFatalFailure(); ++i) {
    const int exponent = static_cast<int>(uniform(random, -25, -15));
    TriangleCorners corners = scaled(uniform_corners(random, -3, 3), exponent);
    corners[0] = scaled(uniform_corners(random, -3, 3), 36)[0];
    std::swap(corners[0], corners[random() % 3]);
    SCOPED_TRACE(to_text(corners));
    expect_minimal(min_sphere(corners), corners, kMinSphereSlack);
  }
}

/// An acute needle whose two long sides are equal in double.
TEST(MinSphere, IsMinimalOfNeedles) {
  for (const float width : {0x1p-149f, 0x1p-100f, 0x1p-40f, 0x1p-20f, 0x1p-6f, 1.0f}) {
    for (const float length : {1.0f, 0x1p20f, 0x1p60f}) {
      const Vec3 tip = {length, 0, 0}, left = {0, width, 0}, right = {0, -width, 0};
      const TriangleCorners turns[] = {{tip, left, right}, {left, right, tip}, {right, tip, left}};
      for (const TriangleCorners& corners : turns) {
        SCOPED_TRACE(to_text(corners));
        expect_minimal(min_sphere(corners), corners, kMinSphereSlack);
      }
    }
  }
}

}  // namespace
}  // namespace pelt::test
