#include "volume/perturbed_points.hpp"

#include "base/assert.hpp"
#include "exact/predicates.hpp"
#include "volume/generic_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pelt::detail {
namespace {

/// A point, or a direction if `weight` is 0, in homogeneous coordinates.
struct Row {
  Vec3 at;
  int weight = 1;
  std::uint32_t number = 0;
};

using Rows = std::array<Row, 4>;

/// The coordinates that are factors of a term: three times the number of the point, plus the axis,
/// plus one, in descending order, then zeros. Arrays compare like exponents of e.
using Exponent = std::array<std::uint64_t, 3>;

struct Term {
  Exponent exponent = {};
  Rounded value;  ///< not zero
};

/// For points, det(b - a, c - a, d - a). Differences are zero without any doubt where points
/// coincide. Precondition: `origin` is the index of a point.
template <typename Number>
Number determinant(const Rows& rows, std::size_t origin) {
  using V = Vector<Number>;
  const auto row = [&](std::size_t i) {
    const Row& other = rows[i < origin ? i : i + 1];
    return other.weight == 0 ? V(other.at) : V(other.at) - V(rows[origin].at);
  };
  const Number volume = dot(row(0), cross(row(1), row(2)));
  return origin % 2 == 0 ? volume : Number(0) - volume;
}

/// The sign is certain, and the error is small. Precondition: a row is a point.
Rounded value_of(const Rows& rows) {
  constexpr double kEnough = 0x1p-43;
  const auto is_point = [](const Row& row) { return row.weight != 0; };
  const auto origin = std::find_if(rows.begin(), rows.end(), is_point) - rows.begin();
  const Rounded value = determinant<Rounded>(rows, static_cast<std::size_t>(origin));
  if (value.error() <= kEnough * std::abs(value.value())) return value;
  const double exact = determinant<Exact>(rows, static_cast<std::size_t>(origin)).rounded();
  return Rounded::within(exact, 0x1p-52 * std::abs(exact));
}

/// The coordinates that are factors of a term. Ascending codes have ascending exponents, if the
/// numbers of the rows ascend.
class Factors {
 public:
  static constexpr unsigned kCount = 256;

  explicit Factors(unsigned code) : code_(code) {}

  /// Whether row `i` has a factor.
  bool has(unsigned i) const { return digit(i) != 0; }

  /// The axis of the factor in row `i`. Precondition: it has one.
  unsigned axis(unsigned i) const { return digit(i) - 1; }

  /// Whether there may be such a term: no two factors are in one column, directions have none, and
  /// a point is left.
  bool belong_to(const Rows& rows) const {
    unsigned columns = 0;
    bool is_point_left = false;
    for (unsigned i = 0; i < rows.size(); ++i) {
      is_point_left |= !has(i) && rows[i].weight != 0;
      if (!has(i)) continue;
      if (rows[i].weight == 0 || (columns >> axis(i) & 1) != 0) return false;
      columns |= 1u << axis(i);
    }
    return is_point_left;
  }

  /// The rows whose determinant is the coefficient.
  Rows minor_of(Rows rows) const {
    for (unsigned i = 0; i < rows.size(); ++i)
      if (has(i)) rows[i] = {unit(axis(i)), 0, rows[i].number};
    return rows;
  }

  Exponent exponent(const Rows& rows) const {
    Exponent exponent = {};
    std::size_t count = 0;
    for (unsigned i = 4; i-- > 0;)
      if (has(i)) exponent[count++] = 3 * std::uint64_t{rows[i].number} + axis(i) + 1;
    return exponent;
  }

 private:
  static Vec3 unit(unsigned axis) {
    return {axis == 0 ? 1.0f : 0.0f, axis == 1 ? 1.0f : 0.0f, axis == 2 ? 1.0f : 0.0f};
  }

  unsigned digit(unsigned i) const { return code_ >> 2 * i & 3; }

  unsigned code_;
};

/// Sorts the rows by number. Returns whether the determinant has changed its sign.
bool sort(Rows& rows) {
  bool is_odd = false;
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (std::size_t k = i; k > 0 && rows[k].number < rows[k - 1].number; --k) {
      std::swap(rows[k], rows[k - 1]);
      is_odd = !is_odd;
    }
  return is_odd;
}

/// The term of the determinant that decides its sign. There is one: if three points have a factor,
/// each along another axis, or two points along y and z, the coefficient is 1 or -1. Precondition:
/// the determinant of the points as they are is zero.
Term leading_term(Rows rows) {
  const double sign = sort(rows) ? -1 : 1;
  for (unsigned code = 1; code < Factors::kCount; ++code) {
    const Factors factors(code);
    if (!factors.belong_to(rows)) continue;
    const Rounded value = value_of(factors.minor_of(rows));
    if (value.value() != 0) return {factors.exponent(rows), Rounded(sign) * value};
  }
  PELT_ASSERT(false);
  return {};
}

Row row_of(const NumberedPoint& point) { return {point.at, 1, point.number}; }

Term height_term(const NumberedTriangle& plane, const NumberedPoint& point) {
  return leading_term({row_of(plane[0]), row_of(plane[1]), row_of(plane[2]), row_of(point)});
}

int sign_of(const Term& term) { return term.value.value() > 0 ? 1 : -1; }

TriangleCorners corners_of(const NumberedTriangle& t) { return {t[0].at, t[1].at, t[2].at}; }

}  // namespace

int perturbed_side(const NumberedTriangle& plane, const NumberedPoint& point) {
  const int side = orient3d(plane[0].at, plane[1].at, plane[2].at, point.at);
  return side != 0 ? side : sign_of(height_term(plane, point));
}

int perturbed_facing(const NumberedTriangle& triangle) {
  const auto& [a, b, c] = triangle;
  if (const int turn = orient2d(without(a.at, 0), without(b.at, 0), without(c.at, 0))) return turn;
  const Row direction = {{1, 0, 0}, 0, UINT32_MAX};
  return sign_of(leading_term({row_of(a), row_of(b), row_of(c), direction}));
}

Rounded perturbed_share(const NumberedTriangle& plane, const NumberedPoint& from,
                        const NumberedPoint& to) {
  const TriangleCorners corners = corners_of(plane);
  if (orient3d(corners[0], corners[1], corners[2], from.at) != 0 ||
      orient3d(corners[0], corners[1], corners[2], to.at) != 0)
    return share_before_plane(from.at, to.at, corners);
  const Term a = height_term(plane, from), b = height_term(plane, to);
  if (a.exponent != b.exponent) return Rounded(a.exponent < b.exponent ? 1 : 0);
  return a.value / (a.value - b.value);
}

namespace {

// The intersection of two triangles.

std::uint8_t after(std::uint8_t corner) { return static_cast<std::uint8_t>((corner + 1) % 3); }

bool is_corner_of(const NumberedTriangle& t, const NumberedPoint& point) {
  return point.number == t[0].number || point.number == t[1].number || point.number == t[2].number;
}

/// Sides of the corners of `t` relative to the plane of `of`: 1 in front, -1 behind, 0 if shared.
std::array<int, 3> sides_of(const NumberedTriangle& t, const NumberedTriangle& of) {
  std::array<int, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = is_corner_of(of, t[i]) ? 0 : perturbed_side(of, t[i]);
  return sides;
}

bool are_all_equal(const std::array<int, 3>& sides) {
  return sides[0] == sides[1] && sides[1] == sides[2];
}

/// Whether an edge passes all edges of `t` on the same side. Precondition: `t` has neither end.
bool passes_through(const NumberedPoint& from, const NumberedPoint& to, const NumberedTriangle& t) {
  const auto turn = [&](std::uint8_t edge) {
    return perturbed_side({from, to, t[edge]}, t[after(edge)]);
  };
  const int first = turn(0);
  return turn(1) == first && turn(2) == first;
}

/// An interval of a on the line of both planes begins where the outline of a comes to the front of
/// b, and an interval of b begins where the outline of b goes behind a (triangle_crossing.cpp).
class Crossing {
 public:
  Crossing(const NumberedTriangle& a, const NumberedTriangle& b)
      : a_(a), b_(b), sides_a_(sides_of(a, b)), sides_b_(sides_of(b, a)) {}

  std::optional<SurfaceCrossing> find() {
    if (are_all_equal(sides_a_) || are_all_equal(sides_b_)) return std::nullopt;
    for (std::uint8_t edge = 0; edge < 3; ++edge) {
      if (pierces(a_, sides_a_, edge, b_)) add_edge_of_a(edge);
      if (pierces(b_, sides_b_, edge, a_)) add_edge_of_b(edge);
    }
    if (count_ == 0) return std::nullopt;
    if (count_ == 1) add_corner();
    return ends_;
  }

 private:
  /// Whether an edge without shared points pierces the other triangle.
  static bool pierces(const NumberedTriangle& own, const std::array<int, 3>& sides,
                      std::uint8_t edge, const NumberedTriangle& other) {
    return sides[edge] * sides[after(edge)] < 0 &&
           passes_through(own[edge], own[after(edge)], other);
  }

  void add_edge_of_a(std::uint8_t edge) {
    const int turn = sides_a_[edge];
    add(turn > 0, {edge, 0, static_cast<std::int8_t>(turn), 0});
  }

  void add_edge_of_b(std::uint8_t edge) {
    const int turn = sides_b_[edge];
    add(turn < 0, {0, edge, 0, static_cast<std::int8_t>(turn)});
  }

  void add(bool is_end, const SegmentEnd& end) {
    last_ = is_end ? 1 : 0;
    ends_[last_] = end;
    ++count_;
  }

  /// Adds the shared point as the other end.
  void add_corner() {
    const std::uint8_t a = shared(sides_a_), b = shared(sides_b_);
    ends_[1 - last_] = {a, b, turn_at(sides_a_, a), turn_at(sides_b_, b)};
  }

  static std::uint8_t shared(const std::array<int, 3>& sides) {
    return sides[0] == 0 ? 0 : sides[1] == 0 ? 1 : 2;
  }

  static std::int8_t turn_at(const std::array<int, 3>& sides, std::uint8_t corner) {
    return static_cast<std::int8_t>(-sides[after(corner)]);
  }

  const NumberedTriangle &a_, &b_;
  const std::array<int, 3> sides_a_, sides_b_;
  SurfaceCrossing ends_;
  std::size_t last_ = 0;
  int count_ = 0;
};

}  // namespace

std::optional<SurfaceCrossing> cross_on_surface(const NumberedTriangle& a,
                                                const NumberedTriangle& b) {
  return Crossing(a, b).find();
}

}  // namespace pelt::detail
