/// The test of neighbours against rational arithmetic, by two oracles: the table in
/// neighbours.hpp, word by word; and, for triangles that have not collapsed, the rule that the
/// table must amount to: a common point that is not in the hull of the shared corners.
#include "self/neighbours.hpp"

#include "exact/finite_floats.hpp"
#include "exact/predicates.hpp"
#include "exact_neighbours.hpp"
#include "geometry/triangle_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

namespace pelt::test {
namespace {

using detail::surface_triangles_intersect;
using detail::SurfaceTriangle;

std::string text_of(const SurfaceTriangle& t) {
  std::ostringstream text;
  text << to_text(t.corners);
  for (const std::uint32_t vertex : t.vertices) text << vertex << " ";
  return text.str();
}

using SurfacePair = std::pair<SurfaceTriangle, SurfaceTriangle>;

/// Compares pairs with both oracles, and counts the kinds of pairs.
class Comparison {
 public:
  explicit Comparison(std::uint64_t seed)
      : seed_(seed), exact_before_(detail::exact_sign_count()) {}

  void add(const SurfacePair& pair) {
    const auto& [a, b] = pair;
    const ExactNeighbours exact(a, b);
    const bool expected = exact.intersect_by_table();
    SCOPED_TRACE(testing::Message() << "seed " << seed_ << ": " << text_of(a) << text_of(b));
    if (!exact.has_collapsed()) {
      ASSERT_EQ(exact.intersect_by_rule(), expected) << "the table is wrong";
    }
    ASSERT_EQ(surface_triangles_intersect(a, b), expected);
    for (std::size_t order = 0; order < 36; ++order) expect_in_order(a, b, order, expected);
    count(exact, expected);
  }

  void print() const {
    std::cout << "seed " << seed_ << ", " << detail::exact_sign_count() - exact_before_
              << " exact signs\n";
    for (const auto& [kind, number] : counts_) std::cout << "  " << kind << ": " << number << "\n";
  }

  /// Expects so many pairs of each kind.
  void expect(std::initializer_list<const char*> kinds, int least) const {
    for (const char* kind : kinds)
      EXPECT_GE(counts_.count(kind) ? counts_.at(kind) : 0, least) << kind;
  }

 private:
  static SurfaceTriangle reordered(const SurfaceTriangle& t, std::size_t order) {
    std::array<std::size_t, 3> corners = {order % 3, (order + 1) % 3, (order + 2) % 3};
    if (order / 3 % 2) std::swap(corners[1], corners[2]);
    SurfaceTriangle result;
    for (std::size_t k = 0; k < 3; ++k) {
      result.corners[k] = t.corners[corners[k]];
      result.vertices[k] = t.vertices[corners[k]];
    }
    return result;
  }

  static void expect_in_order(const SurfaceTriangle& a, const SurfaceTriangle& b, std::size_t order,
                              bool expected) {
    const SurfaceTriangle of_a = reordered(a, order % 6), of_b = reordered(b, order / 6);
    ASSERT_EQ(surface_triangles_intersect(of_a, of_b), expected) << "order " << order;
    ASSERT_EQ(surface_triangles_intersect(of_b, of_a), expected) << "swapped, order " << order;
  }

  void count(const ExactNeighbours& exact, bool hit) {
    const bool has_collapsed = exact.has_collapsed();
    std::ostringstream kind;
    kind << (has_collapsed ? "collapsed, " : "") << "share " << exact.shared_count()
         << (hit ? ", hit" : ", no hit");
    ++counts_[kind.str()];
    if (has_collapsed || exact.shared_count() != 2) return;
    if (exact.is_flat()) ++counts_[exact.is_folded_flat() ? "folded flat" : "flat, not folded"];
  }

  std::uint64_t seed_, exact_before_;
  std::map<std::string, int> counts_;
};

/// Two triangles over few surface vertices, whose positions `coordinate` draws. Positions of
/// different vertices may be equal. One corner in 20 is at another position than its vertex (a
/// crack that opens), and one triangle in 10 has equal corners.
template <typename MakePoint>
SurfacePair random_pair(Random& random, std::uint32_t vertex_count, const MakePoint& make_point) {
  std::array<Vec3, 6> positions;
  for (Vec3& position : positions) position = make_point(random);
  SurfacePair pair;
  for (SurfaceTriangle* t : {&pair.first, &pair.second}) {
    std::array<std::uint32_t, 6> vertices = {0, 1, 2, 3, 4, 5};
    std::shuffle(vertices.begin(), vertices.begin() + vertex_count, random);
    if (random() % 10 == 0) vertices[random() % 3] = vertices[random() % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      t->vertices[k] = vertices[k];
      t->corners[k] = random() % 20 ? positions[vertices[k]] : make_point(random);
    }
  }
  return pair;
}

template <typename MakePoint>
void compare(Comparison& comparison, Random& random, int pairs, const MakePoint& make_point) {
  for (int i = 0; i < pairs && !testing::Test::HasFailure(); ++i)
    comparison.add(random_pair(random, 4 + static_cast<std::uint32_t>(i) % 3, make_point));
}

constexpr auto kKinds = {"share 0, hit", "share 0, no hit", "share 1, hit", "share 1, no hit",
                         "share 2, hit", "share 2, no hit", "share 3, hit"};
constexpr auto kCollapsedKinds = {"collapsed, share 0, hit", "collapsed, share 0, no hit",
                                  "collapsed, share 1, hit", "collapsed, share 1, no hit",
                                  "collapsed, share 2, hit", "collapsed, share 2, no hit",
                                  "collapsed, share 3, hit"};

/// A point of a grid of this many points along each axis, at a distance of 2^exponent.
template <int kSize, int kExponent>
Vec3 grid_point(Random& random) {
  const auto coordinate = [&] {
    return std::ldexp(static_cast<float>(random() % kSize), kExponent);
  };
  return {coordinate(), coordinate(), coordinate()};
}

TEST(NeighbourPair, OnSmallGrids) {
  Random random(1700);
  Comparison comparison(1700);
  compare(comparison, random, 2'000, grid_point<2, 0>);
  compare(comparison, random, 4'000, grid_point<3, -149>);
  compare(comparison, random, 3'000, grid_point<4, 125>);
  comparison.print();
  comparison.expect(kKinds, 60);
  comparison.expect(kCollapsedKinds, 30);
  comparison.expect({"folded flat", "flat, not folded"}, 100);
}

/// Almost all pairs lie in one sloping plane.
TEST(NeighbourPair, InOnePlane) {
  Random random(1701);
  Comparison comparison(1701);
  compare(comparison, random, 4'000, [](Random& r) {
    const auto x = static_cast<float>(r() % 5), y = static_cast<float>(r() % 4);
    return Vec3{x, y, 2 * x - 3 * y + static_cast<float>(r() % 50 == 0)};
  });
  comparison.print();
  comparison.expect(kKinds, 15);
  comparison.expect(kCollapsedKinds, 30);
  comparison.expect({"folded flat", "flat, not folded"}, 300);
}

/// A grid under a linear map with determinant one and large coefficients: volumes stay one unit,
/// which double precision cannot tell from zero.
TEST(NeighbourPair, OnShearedGrids) {
  Random random(1702);
  Comparison comparison(1702);
  for (int i = 0; i < 4'000 && !HasFailure(); ++i) {
    const IntegerPair grid = sheared_grid(random);
    std::vector<Vec3> positions;
    for (const IntegerCorners& corners : {grid.a, grid.b})
      for (const Vec3& p : scaled(corners, -24)) positions.push_back(p);
    std::size_t next = 0;
    comparison.add(random_pair(random, 4 + static_cast<std::uint32_t>(i) % 3,
                               [&](Random&) { return positions[next++ % positions.size()]; }));
  }
  comparison.print();
  comparison.expect(kKinds, 15);
  comparison.expect(kCollapsedKinds, 15);
  comparison.expect({"folded flat", "flat, not folded"}, 30);
}

TEST(NeighbourPair, AnyFiniteFloats) {
  Random random(1703);
  Comparison comparison(1703);
  const auto point_of = [](float (*coordinate)(Random&)) {
    return [coordinate](Random& r) {
      const float x = coordinate(r), y = coordinate(r);
      return Vec3{x, y, coordinate(r)};
    };
  };
  compare(comparison, random, 800, point_of(any_finite_float));
  compare(comparison, random, 2'000, point_of(one_of_few_floats));
  comparison.print();
  comparison.expect({"share 0, hit", "share 1, hit", "share 1, no hit", "share 2, no hit"}, 30);
}

}  // namespace
}  // namespace pelt::test
