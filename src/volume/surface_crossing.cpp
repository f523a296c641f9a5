#include "volume/surface_crossing.hpp"

#include "base/assert.hpp"

namespace pelt::detail {
namespace {

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
