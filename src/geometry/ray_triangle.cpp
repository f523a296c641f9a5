/// Let a' = a - o and so on be the vertices relative to the origin o, and d the direction. The line
/// passes the three edges on the sides given by the signs of
///     w_a = det(d, b', c'),  w_b = det(d, c', a'),  w_c = det(d, a', b'),
/// which sum to d.n for the normal n = (b - a) x (c - a). If no two have different signs and not
/// all are zero, the line is not parallel to the plane and hits the triangle at t = a'.n / d.n,
/// where each vertex has the weight w / d.n. If all are zero, the line is in the plane or the
/// triangle has collapsed. For an edge that two triangles share, both determinants are the same
/// numbers up to sign, so with exact signs no ray passes between the triangles.
///
/// Rounding, with e = 2^-53. A determinant of three vectors is a sum of six products. Of the
/// factors of a product, at most three are differences, with an error e each; two multiplications
/// and three sums add five. The error is therefore at most 6 * 8 e |p||q||r| in the largest
/// components, and 56 e covers terms of second order and the rounding of the bound, as in
/// predicates.hpp.
#include "geometry/ray_triangle.hpp"

#include "exact/exact_determinant.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {
namespace {

constexpr double kRoundingUnit = 0x1p-53;
constexpr double kDeterminantError = 56 * kRoundingUnit;

/// Capacity for four determinants of floats, with two terms for each of six products.
using Sum3d = ExactSum<48>;

double determinant(const Vec3d& p, const Vec3d& q, const Vec3d& r) { return dot(p, cross(q, r)); }

/// det(d, q - o, r - o), exactly.
Sum3d exact_edge(const RayLine& line, const Vec3& q, const Vec3& r) {
  const Vec3d d(line.direction), o(line.origin);
  Sum3d sum;
  add_determinant(sum, d, Vec3d(q), Vec3d(r));
  add_determinant(sum, d, o, Vec3d(q));
  add_determinant(sum, d, Vec3d(r), o);
  return sum;
}

/// The exact determinants of the three edges; element k belongs to the edge opposite to corner k.
std::array<Sum3d, 3> exact_edges(const RayLine& line, const TriangleCorners& t) {
  return {exact_edge(line, t[1], t[2]), exact_edge(line, t[2], t[0]), exact_edge(line, t[0], t[1])};
}

/// d.n, exactly.
Sum3d exact_slope(const RayLine& line, const TriangleCorners& t) {
  const Vec3d d(line.direction), a(t[0]), b(t[1]), c(t[2]);
  Sum3d sum;
  add_determinant(sum, d, b, c);
  add_determinant(sum, d, c, a);
  add_determinant(sum, d, a, b);
  return sum;
}

/// (a - o).n, exactly.
Sum3d exact_height(const RayLine& line, const TriangleCorners& t) {
  const Vec3d o(line.origin), a(t[0]), b(t[1]), c(t[2]);
  Sum3d sum;
  add_determinant(sum, a, b, c);
  add_determinant(sum, b, a, o);
  add_determinant(sum, c, b, o);
  add_determinant(sum, a, c, o);
  return sum;
}

/// The side of the line on which each edge passes, by the corner opposite to the edge.
using Sides = std::array<int, 3>;

/// Whether two edges pass on different sides.
bool on_both_sides(const Sides& sides) {
  return std::min({sides[0], sides[1], sides[2]}) < 0 &&
         std::max({sides[0], sides[1], sides[2]}) > 0;
}

/// The sides that double arithmetic decides, 0 for undecided ones, and whether all are decided.
struct CertainSides {
  Sides sides;
  bool all;
};

CertainSides certain_sides(const RayLine& line, const TriangleCorners& t) {
  const Vec3d d(line.direction), o(line.origin);
  const Vec3d a = Vec3d(t[0]) - o, b = Vec3d(t[1]) - o, c = Vec3d(t[2]) - o;
  const double reach = std::max(std::max(max_abs(a), max_abs(b)), max_abs(c));
  const double error = kDeterminantError * max_abs(d) * reach * reach;
  const double w[3] = {determinant(d, b, c), determinant(d, c, a), determinant(d, a, b)};
  CertainSides certain = {{}, true};
  for (std::size_t i = 0; i < 3; ++i) {
    certain.sides[i] = int{w[i] > error} - int{w[i] < -error};
    certain.all &= certain.sides[i] != 0;
  }
  return certain;
}

/// Returns all sides. Precondition: the nonzero sides of `certain` are right.
Sides exact_sides(const RayLine& line, const TriangleCorners& t, const Sides& certain) {
  Sides sides = certain;
  for (std::size_t i = 0; i < 3; ++i)
    if (sides[i] == 0) sides[i] = edge_side(line, t[(i + 1) % 3], t[(i + 2) % 3]);
  return sides;
}

/// Floats end where the next one would be 2^128.
double next_beyond(float value) {
  return std::isfinite(value) ? double{value} : std::copysign(0x1p128, value);
}

/// The float nearest to height / slope; of two that are equally near, the even one.
float exact_quotient(const Sum3d& height, const Sum3d& slope) {
  const double quotient = height.rounded() / slope.rounded();
  const double error = std::abs(quotient) * 0x1p-48;
  const auto low = static_cast<float>(quotient - error),
             high = static_cast<float>(quotient + error);
  if (low == high) return low;
  const double middle = (next_beyond(low) + next_beyond(high)) / 2;
  ExactSum<48 + 2 * 48> beyond;  // height - middle * slope
  for (const double term : height.terms()) beyond.add(term);
  for (const double term : slope.terms()) {
    const ExactProduct product(-middle, term);
    beyond.add(product.error);
    beyond.add(product.value);
  }
  const int side = beyond.sign() * slope.sign();
  return side > 0 ? high : side < 0 ? low : static_cast<float>(middle);
}

/// The float nearest to the line's t in the triangle's plane. Precondition: not parallel.
///
/// With errors of p in the height and q in the slope, the quotient t is wrong by at most
/// (p + |t| q) / (|slope| - q), beside two roundings; q may be 2^-20 of the slope.
float nearest_t(const RayLine& line, const TriangleCorners& t) {
  const Vec3d a(t[0]), u = Vec3d(t[1]) - a, v = Vec3d(t[2]) - a, n = cross(u, v);
  const Vec3d d(line.direction), from_origin = a - Vec3d(line.origin);
  const double slope = dot(d, n), per_slope = 1 / slope;
  const double quotient = dot(from_origin, n) * per_slope;
  const double per_length = kDeterminantError * max_abs(u) * max_abs(v);
  const double slope_error = per_length * max_abs(d);
  if (slope_error < 0x1p-20 * std::abs(slope)) {
    const double error =
        1.00001 * std::abs(per_slope) *
            (per_length * max_abs(from_origin) + slope_error * std::abs(quotient)) +
        4 * kRoundingUnit * std::abs(quotient);
    const auto low = static_cast<float>(quotient - error);
    if (low == static_cast<float>(quotient + error)) return low;
  }
  return exact_quotient(exact_height(line, t), exact_slope(line, t));
}

/// Divides the three numbers by their sum, without those opposite to an edge that is hit.
std::array<float, 3> shares(const std::array<double, 3>& w, const RayCrossing& crossing) {
  const double per_sum = 1 / (w[0] + w[1] + w[2]);
  std::array<float, 3> weights;
  for (std::size_t i = 0; i < 3; ++i)
    weights[i] = crossing.on_edge[i] ? 0 : static_cast<float>(std::max(w[i] * per_sum, 0.0));
  return weights;
}

}  // namespace

int edge_side(const RayLine& line, const Vec3& q, const Vec3& r) {
  return exact_edge(line, q, r).sign();
}

bool line_meets_triangle(const RayLine& line, const TriangleCorners& triangle,
                         RayCrossing& crossing) {
  const CertainSides certain = certain_sides(line, triangle);
  if (on_both_sides(certain.sides)) return false;
  const Sides sides = certain.all ? certain.sides : exact_sides(line, triangle, certain.sides);
  if (on_both_sides(sides) || sides == Sides{0, 0, 0}) return false;
  crossing.t = nearest_t(line, triangle) + 0.0f;
  crossing.from_front = std::min({sides[0], sides[1], sides[2]}) < 0;
  crossing.on_edge = {sides[0] == 0, sides[1] == 0, sides[2] == 0};
  return std::isfinite(crossing.t);
}

bool line_pierces_triangle(const RayLine& line, const TriangleCorners& triangle, bool from_front,
                           RayCrossing& crossing) {
  crossing = {nearest_t(line, triangle) + 0.0f, from_front, {}};
  return std::isfinite(crossing.t);
}

/// The determinants are the same for any origin on the line. With an origin near the triangle, the
/// point of the rounded t, little cancels. t * d is exact in double, so a vertex relative to the
/// new origin has an error of e times its distances from the old origin, at most `reach`, and from
/// the new one, at most `size`. The errors of the six products are then 2 e (reach + size) size
/// each, in addition to their own 8 e size^2.
std::array<float, 3> crossing_weights(const RayLine& line, const TriangleCorners& triangle,
                                      const RayCrossing& crossing) {
  const Vec3d d(line.direction), o(line.origin);
  Vec3d seen[3];
  double reach = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d from_origin = Vec3d(triangle[i]) - o;
    seen[i] = from_origin - double{crossing.t} * d;
    reach = std::max(reach, max_abs(from_origin));
    size = std::max(size, max_abs(seen[i]));
  }
  std::array<double, 3> w = {determinant(d, seen[1], seen[2]), determinant(d, seen[2], seen[0]),
                             determinant(d, seen[0], seen[1])};
  const double error = 80 * kRoundingUnit * max_abs(d) * size * (reach + size);
  if (!(error < 0x1p-28 * std::abs(w[0] + w[1] + w[2]))) {
    const std::array<Sum3d, 3> exact = exact_edges(line, triangle);
    w = {exact[0].rounded(), exact[1].rounded(), exact[2].rounded()};
  }
  return shares(w, crossing);
}

/// A component is a difference of two products with errors of 4 e |u||v| each.
Vec3d area_vector(const TriangleCorners& triangle) {
  const Vec3d a(triangle[0]), b(triangle[1]), c(triangle[2]);
  const Vec3d u = b - a, v = c - a;
  Vec3d n = cross(u, v);
  if (!(9 * kRoundingUnit * max_abs(u) * max_abs(v) < 0x1p-25 * max_abs(n))) {
    const auto twice_area = [](double ax, double ay, double bx, double by, double cx, double cy) {
      ExactSum<6> sum;
      for (const double term : {ax * by, bx * cy, cx * ay}) sum.add(term);
      for (const double term : {bx * ay, cx * by, ax * cy}) sum.add(-term);
      return sum.rounded();
    };
    n = {twice_area(a.y, a.z, b.y, b.z, c.y, c.z), twice_area(a.z, a.x, b.z, b.x, c.z, c.x),
         twice_area(a.x, a.y, b.x, b.y, c.x, c.y)};
  }
  return n;
}

Vec3 unit_normal(const TriangleCorners& triangle) {
  const Vec3d n = area_vector(triangle);
  return to_float(1 / std::sqrt(squared_length(n)) * n);
}

}  // namespace pelt::detail
