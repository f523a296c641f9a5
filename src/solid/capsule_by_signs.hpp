#pragma once

/// The features of a triangle that are within the radius of features of a capsule's segment, by
/// signs of polynomials. The distance between a triangle and a disjoint segment is attained between
/// two features, in the interior of each: a corner or end against a corner, end, edge or face, or
/// an edge against the segment (Ericson 2005, 5.1.9 and 5.1.10). Each pair is tested without
/// division. With w from one feature to the other and the radius r, the closest points are within r
/// if
///
///   vertices        (w . w) <= r^2
///   along an edge e, at t = (w . e) / (e . e) in (0, 1): (w . w - r^2) (e . e) <= (w . e)^2
///   on a face with the normal n, if the projection is inside: (w . n)^2 <= r^2 (n . n)
///   of two edges d and e, n = d x e, at (w x e . n) / (n . n) and (w x d . n) / (n . n) in [0, 1]:
///                   (w . n)^2 <= r^2 (n . n)
///
/// The degree of these polynomials is at most six.

#include "exact/exact_number.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// A feature of the triangle and one of the segment. Points 0, 1 and 2 are corners of the triangle,
/// 3 and 4 are ends of the segment.
struct CapsulePair {
  enum class Kind : std::uint8_t { points, point_and_edge, point_and_face, edge_and_segment };

  Kind kind = Kind::points;
  std::uint8_t point = 0;  ///< unless the kind is edge_and_segment
  std::uint8_t first = 0;  ///< the other point, or the first point of the edge
  std::uint8_t last = 0;   ///< the last point of the edge
};

/// Pairs of a corner of the triangle and a feature of the segment: of a sphere, only the first.
inline std::array<CapsulePair, 3> pairs_of_corner(std::uint8_t corner) {
  using Kind = CapsulePair::Kind;
  return {{{Kind::points, corner, 3, 0},
           {Kind::points, corner, 4, 0},
           {Kind::point_and_edge, corner, 3, 4}}};
}

/// The other pairs: of a sphere, only the first four.
inline constexpr std::array<CapsulePair, 11> kPairsOfEdgesAndFace = {
    {{CapsulePair::Kind::point_and_edge, 3, 0, 1},
     {CapsulePair::Kind::point_and_edge, 3, 1, 2},
     {CapsulePair::Kind::point_and_edge, 3, 2, 0},
     {CapsulePair::Kind::point_and_face, 3, 0, 0},
     {CapsulePair::Kind::point_and_edge, 4, 0, 1},
     {CapsulePair::Kind::point_and_edge, 4, 1, 2},
     {CapsulePair::Kind::point_and_edge, 4, 2, 0},
     {CapsulePair::Kind::point_and_face, 4, 0, 0},
     {CapsulePair::Kind::edge_and_segment, 0, 0, 1},
     {CapsulePair::Kind::edge_and_segment, 0, 1, 2},
     {CapsulePair::Kind::edge_and_segment, 0, 2, 0}}};

/// `Source` gives numbers and signs:
///   Vector<Number> from_to<Number>(i, j) const   from point i to point j
///   Number squared_radius<Number>() const
///   int sign(polynomial) const                   of a template `polynomial(const Number&)`
template <typename Source>
class CapsuleBySigns {
 public:
  CapsuleBySigns(const Source& source, bool is_sphere) : source_(source), is_sphere_(is_sphere) {}

  bool is_near(const CapsulePair& pair) const {
    return is_beside(pair) &&
           source_.sign([&]<typename Number>(const Number&) { return beyond<Number>(pair); }) <= 0;
  }

  bool is_inside(std::uint8_t corner) const {
    const auto pairs = pairs_of_corner(corner);
    return is_near(pairs[0]) || (!is_sphere_ && (is_near(pairs[1]) || is_near(pairs[2])));
  }

  bool is_edge_or_face_near() const {
    const std::size_t count = is_sphere_ ? 4 : kPairsOfEdgesAndFace.size();
    for (std::size_t i = 0; i < count; ++i)
      if (is_near(kPairsOfEdgesAndFace[i])) return true;
    return false;
  }

  /// Whether the points of the extended features that are closest to each other belong to the
  /// features.
  bool is_beside(const CapsulePair& pair) const {
    switch (pair.kind) {
      case CapsulePair::Kind::points:
        return true;
      case CapsulePair::Kind::point_and_edge:
        return is_beside_edge(pair.point, pair.first, pair.last);
      case CapsulePair::Kind::point_and_face:
        return is_over_face(pair.point);
      case CapsulePair::Kind::edge_and_segment:
        return are_beside(pair.first, pair.last);
    }
    return false;
  }

  /// A polynomial that is positive if these points are farther apart than the radius, and zero if
  /// their distance equals the radius.
  template <typename Number>
  Number beyond(const CapsulePair& pair) const {
    const auto squared_radius = [this] { return source_.template squared_radius<Number>(); };
    const auto of_normal = [&](const Vector<Number>& w, const Vector<Number>& n) {
      return square(dot(w, n)) - squared_radius() * squared_length(n);
    };
    switch (pair.kind) {
      case CapsulePair::Kind::points:
        break;
      case CapsulePair::Kind::point_and_edge: {
        const Vector<Number> w = from_to<Number>(pair.first, pair.point);
        const Vector<Number> e = from_to<Number>(pair.first, pair.last);
        return (squared_length(w) - squared_radius()) * squared_length(e) - square(dot(w, e));
      }
      case CapsulePair::Kind::point_and_face:
        return of_normal(from_to<Number>(0, pair.point), face_normal<Number>());
      case CapsulePair::Kind::edge_and_segment:
        return of_normal(from_to<Number>(3, pair.first), normal<Number>(pair.first, pair.last));
    }
    return squared_length(from_to<Number>(pair.first, pair.point)) - squared_radius();
  }

 private:
  template <typename Number>
  static Number square(const Number& a) {
    return a * a;
  }

  template <typename Number>
  Vector<Number> from_to(std::size_t i, std::size_t j) const {
    return source_.template from_to<Number>(i, j);
  }

  template <typename Number>
  Vector<Number> face_normal() const {
    return cross(from_to<Number>(0, 1), from_to<Number>(0, 2));
  }

  /// Returns the cross product of the segment and an edge.
  template <typename Number>
  Vector<Number> normal(std::size_t p, std::size_t q) const {
    return cross(from_to<Number>(3, 4), from_to<Number>(p, q));
  }

  bool is_beside_edge(std::size_t c, std::size_t p, std::size_t q) const {
    const auto along = [&]<typename Number>(const Number&) {
      return dot(from_to<Number>(p, c), from_to<Number>(p, q));
    };
    return source_.sign(along) > 0 && source_.sign([&]<typename Number>(const Number& number) {
      return squared_length(from_to<Number>(p, q)) - along(number);
    }) > 0;
  }

  bool is_over_face(std::size_t c) const {
    if (source_.sign([&]<typename Number>(const Number&) {
          return squared_length(face_normal<Number>());
        }) == 0)
      return false;
    for (std::size_t p = 0; p < 3; ++p)
      if (source_.sign([&]<typename Number>(const Number&) {
            return dot(face_normal<Number>(),
                       cross(from_to<Number>(p, (p + 1) % 3), from_to<Number>(p, c)));
          }) < 0)
        return false;
    return true;
  }

  /// Whether the closest points of the segment and the edge pq are inside both.
  bool are_beside(std::size_t p, std::size_t q) const {
    const auto squared_normal = [&]<typename Number>(const Number&) {
      return squared_length(normal<Number>(p, q));
    };
    const auto is_within = [&](std::size_t from, std::size_t to) {
      const auto place = [&]<typename Number>(const Number&) {
        return dot(cross(from_to<Number>(3, p), from_to<Number>(from, to)), normal<Number>(p, q));
      };
      return source_.sign(place) >= 0 && source_.sign([&](const auto& number) {
        return squared_normal(number) - place(number);
      }) >= 0;
    };
    return source_.sign(squared_normal) > 0 && is_within(p, q) && is_within(3, 4);
  }

  const Source& source_;
  bool is_sphere_;
};

}  // namespace pelt::detail
