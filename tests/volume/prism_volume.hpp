#pragma once

/// The integral of w_a w_b over space by another method than the library: the winding number around
/// a point is the sum of signs of the triangles above it, so w_a w_b is a sum over pairs of
/// triangles, of the signed volume below both. Nothing is decided except on which side of a line
/// points are, and points on the line may be on either side. With rational numbers, the result is
/// exact.

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pelt::test {

template <typename Number>
class PrismVolume {
 public:
  PrismVolume(std::span<const Vec3> posed, std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles) add(posed[t[0]], posed[t[1]], posed[t[2]]);
  }

  /// The integral of the product of both winding numbers.
  Number of_intersection(const PrismVolume& other) const {
    Number sum(0);
    for (const Prism& a : prisms_)
      for (const Prism& b : other.prisms_)
        if (may_overlap(a, b)) sum += below_both(a, b);
    return sum;
  }

 private:
  /// A function a x + b y + c.
  struct Linear {
    Number a, b, c;

    Number operator()(const std::array<Number, 2>& p) const {
      return Number(a * p[0] + b * p[1] + c);
    }
  };

  using Polygon = std::vector<std::array<Number, 2>>;

  /// All points below a triangle.
  struct Prism {
    int sign;  ///< 1 if the triangle faces up
    Polygon outline;
    std::array<Linear, 3> inside;  ///< not negative inside
    Linear height;
    std::array<float, 4> box;  ///< least x and y, greatest x and y
  };

  void add(const Vec3& p, const Vec3& q, const Vec3& r) {
    using Point = std::array<Number, 3>;
    const auto exact = [](const Vec3& v) {
      return Point{Number(double{v.x}), Number(double{v.y}), Number(double{v.z})};
    };
    std::array<Point, 3> corners = {exact(p), exact(q), exact(r)};
    const auto edge = [&](std::size_t to, std::size_t axis) {
      return Number(corners[to][axis] - corners[0][axis]);
    };
    Number area(edge(1, 0) * edge(2, 1) - edge(2, 0) * edge(1, 1));
    if (area == 0) return;
    Prism prism;
    prism.sign = area > 0 ? 1 : -1;
    if (area < 0) {
      std::swap(corners[1], corners[2]);
      area = -area;
    }
    const Number slope_x((edge(1, 2) * edge(2, 1) - edge(2, 2) * edge(1, 1)) / area);
    const Number slope_y((edge(1, 0) * edge(2, 2) - edge(2, 0) * edge(1, 2)) / area);
    prism.height = {slope_x, slope_y,
                    Number(corners[0][2] - slope_x * corners[0][0] - slope_y * corners[0][1])};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &from = corners[i], &to = corners[(i + 1) % 3];
      prism.outline.push_back({from[0], from[1]});
      const Number a(from[1] - to[1]), b(to[0] - from[0]);
      prism.inside[i] = {a, b, Number(-(a * from[0] + b * from[1]))};
    }
    prism.box = {std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}), std::max({p.x, q.x, r.x}),
                 std::max({p.y, q.y, r.y})};
    prisms_.push_back(prism);
  }

  static bool may_overlap(const Prism& a, const Prism& b) {
    return a.box[0] < b.box[2] && b.box[0] < a.box[2] && a.box[1] < b.box[3] && b.box[1] < a.box[3];
  }

  /// The part of a convex polygon where `side` is not negative.
  static Polygon clip(const Polygon& polygon, const Linear& side) {
    Polygon clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Number at_p = side(p), at_q = side(q);
      if (at_p >= 0) clipped.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
        const Number t(at_p / (at_p - at_q));
        clipped.push_back({Number(p[0] + t * (q[0] - p[0])), Number(p[1] + t * (q[1] - p[1]))});
      }
    }
    return clipped;
  }

  static Number integral(const Polygon& polygon, const Linear& f) {
    Number sum(0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const auto &p = polygon[0], &q = polygon[i - 1], &r = polygon[i];
      const Number area((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]));
      sum += Number(area * (f(p) + f(q) + f(r)) / 6);
    }
    return sum;
  }

  static Number below_both(const Prism& a, const Prism& b) {
    Polygon common = a.outline;
    for (const Linear& side : b.inside) common = clip(common, side);
    const Linear above = {Number(a.height.a - b.height.a), Number(a.height.b - b.height.b),
                          Number(a.height.c - b.height.c)};
    const Linear below = {Number(-above.a), Number(-above.b), Number(-above.c)};
    const bool is_same = above.a == 0 && above.b == 0 && above.c == 0;
    Number volume = is_same ? integral(common, a.height)
                            : Number(integral(clip(common, above), b.height) +
                                     integral(clip(common, below), a.height));
    if (a.sign != b.sign) volume = -volume;
    return volume;
  }

  std::vector<Prism> prisms_;
};

}  // namespace pelt::test
