/// Decisions about points in general position, against the same points moved by a small number e
/// that is written out: 2^-32, whose powers are distinct from each other by far more than the
/// coefficients of any term.

#include "volume/perturbed_points.hpp"

#include "exact/predicates.hpp"
#include "support/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

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
