/// The test of neighbours against rational arithmetic, by two oracles: the table in
/// neighbour_pair.hpp, word by word; and, for triangles that have not collapsed, the rule that the
/// table must amount to: a common point that is not in the hull of the shared corners.
#include "geometry/neighbour_pair.hpp"

#include "common_points.hpp"
#include "finite_floats.hpp"
#include "geometry/predicates.hpp"
#include "triangle_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

namespace pelt::test {
namespace {

using detail::surface_triangles_intersect;
using detail::SurfaceTriangle;

/// A corner with its surface vertex. Equal corners are shared.
struct Corner {
  std::uint32_t vertex;
  RationalPoint point;

  friend bool operator==(const Corner& a, const Corner& b) {
    return a.vertex == b.vertex && a.point == b.point;
  }
};

using Corners = std::vector<Corner>;

Corners distinct_corners(const SurfaceTriangle& t) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner corner = {t.vertices[i], to_rational(t.corners[i])};
    if (std::find(corners.begin(), corners.end(), corner) == corners.end())
      corners.push_back(corner);
  }
  return corners;
}

/// The points of the corners of `a` that `b` also has, or does not have.
RationalPoints points(const Corners& a, const Corners& b, bool shared) {
  RationalPoints chosen;
  for (const Corner& corner : a)
    if ((std::find(b.begin(), b.end(), corner) != b.end()) == shared)
      chosen.push_back(corner.point);
  return chosen;
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A pair of triangles in exact arithmetic.
struct ExactPair {
  ExactPair(const SurfaceTriangle& a, const SurfaceTriangle& b) {
    const Corners of_a = distinct_corners(a), of_b = distinct_corners(b);
    all_a = points(of_a, {}, false), all_b = points(of_b, {}, false);
    shared = points(of_a, of_b, true);
    own_a = points(of_a, of_b, false), own_b = points(of_b, of_a, false);
  }

  static bool has_collapsed(const RationalPoints& t) {
    return t.size() < 3 ||
           cross(difference(t[1], t[0]), difference(t[2], t[0])) == RationalPoint{0, 0, 0};
  }
  bool has_collapsed() const { return has_collapsed(all_a) || has_collapsed(all_b); }

  /// Whether two shared corners exist, and the other corners lie in one plane with them, strictly
  /// on the same side.
  bool is_folded_flat() const {
    if (shared.size() != 2 || own_a.size() != 1 || own_b.size() != 1) return false;
    const RationalPoint edge = difference(shared[1], shared[0]);
    const RationalPoint to_a = cross(edge, difference(own_a[0], shared[0]));
    const RationalPoint to_b = cross(edge, difference(own_b[0], shared[0]));
    return cross(to_a, to_b) == RationalPoint{0, 0, 0} && dot(to_a, to_b) > 0;
  }

  bool by_table() const {
    if (shared.empty()) return hulls_intersect(all_a, all_b);
    if (own_a.empty() && own_b.empty()) return true;
    return is_folded_flat() || (!own_a.empty() && hulls_intersect(own_a, all_b)) ||
           (!own_b.empty() && hulls_intersect(own_b, all_a));
  }

  /// Precondition: the triangles have not collapsed.
  bool by_rule() const {
    if (shared.size() == 3) return true;
    for (const RationalPoint& point : common_points(all_a, all_b))
      if (shared.empty() || !hulls_intersect({point}, shared)) return true;
    return false;
  }

  RationalPoints all_a, all_b, shared, own_a, own_b;
};

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
    const ExactPair exact(a, b);
    const bool expected = exact.by_table();
    SCOPED_TRACE(testing::Message() << "seed " << seed_ << ": " << text_of(a) << text_of(b));
    if (!exact.has_collapsed()) {
      ASSERT_EQ(exact.by_rule(), expected) << "the table is wrong";
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

  void count(const ExactPair& exact, bool hit) {
    const bool has_collapsed = exact.has_collapsed();
    std::ostringstream kind;
    kind << (has_collapsed ? "collapsed, " : "") << "share " << exact.shared.size()
         << (hit ? ", hit" : ", no hit");
    ++counts_[kind.str()];
    if (has_collapsed || exact.shared.size() != 2) return;
    if (is_coplanar(exact)) ++counts_[exact.is_folded_flat() ? "folded flat" : "flat, not folded"];
  }

  static bool is_coplanar(const ExactPair& exact) {
    const RationalPoint normal = cross(difference(exact.all_a[1], exact.all_a[0]),
                                       difference(exact.all_a[2], exact.all_a[0]));
    return dot(normal, difference(exact.own_b[0], exact.shared[0])) == 0;
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
