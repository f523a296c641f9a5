#pragma once

/// For each of the fifteen determinants, whether its features, a corner and a face or two edges,
/// intersect at a time at which it is zero: by the signs of others at that time.
///
/// Corner j of b and the face of a. Edge j of b, and the edge before it, are on lines that meet a's
/// plane in this corner. If a line passes two edges of a on different sides, it does not meet a. If
/// it passes all three on one side, it pierces a inside, and there is no other point of a's plane
/// on it: the corner.
///
/// Edges i of a and j of b. If both ends of one are on one side of the other triangle's plane, the
/// edges are disjoint. Otherwise, if the ends of both are on different sides, each edge has exactly
/// one point in the other triangle's plane, between its ends. The lines of the edges are in one
/// plane and not parallel, so they meet, and they can only do so in both of these points.

#include "motion/moving_pieces.hpp"

#include <cstdint>

namespace pelt::detail {
namespace moving {

/// The features of a determinant.
struct FeaturePair {
  enum class Kind : std::uint8_t { face_and_corner, corner_and_face, edges } kind;
  std::uint8_t i = 0, j = 0;  ///< the corner or edge of a and that of b; 0 for a face

  explicit FeaturePair(unsigned determinant) : kind(Kind::edges) {
    if (determinant < over_b(0)) {
      kind = Kind::face_and_corner, j = small(determinant - over_a(0));
    } else if (determinant < edges(0, 0)) {
      kind = Kind::corner_and_face, i = small(determinant - over_b(0));
    } else {
      const unsigned pair = determinant - edges(0, 0);
      i = small(pair / 3), j = small(pair % 3);
    }
  }

 private:
  static std::uint8_t small(unsigned number) { return static_cast<std::uint8_t>(number); }
};

// Three bits: of corners or edges. Nine bits: of pairs of edges, bit 3 i + j for i of a and j of b.

inline Signs three(const Signs& signs, unsigned first) {
  return {signs.positive >> first & 7, signs.negative >> first & 7};
}

/// The bits of the next corners or edges.
constexpr unsigned next(unsigned three) { return three >> 1 | (three & 1) << 2; }
inline Signs next(const Signs& three) { return {next(three.positive), next(three.negative)}; }

/// The corners at which edges begin or end: those of the same numbers, and the next ones.
constexpr unsigned ends_of(unsigned edges_of_one) {
  return edges_of_one | next(next(edges_of_one));
}

/// The first bit of each row, an edge of a.
constexpr unsigned first_of_rows(unsigned nine) {
  return (nine & 1) | (nine >> 2 & 2) | (nine >> 4 & 4);
}

/// All pairs with some edges of a, or of b.
constexpr unsigned rows(unsigned of_a) {
  return 7 * ((of_a & 1) | (of_a & 2) << 2 | (of_a & 4) << 4);
}
constexpr unsigned columns(unsigned of_b) { return 0b001001001 * of_b; }

/// Lines of edges of one triangle, as seen from the edges of the other one.
struct Lines {
  unsigned between;   ///< those that pass two edges on different sides
  unsigned piercing;  ///< those that pass three edges on one side

  static Lines of_a(const Signs& nine) {
    const auto any = [](unsigned n) { return first_of_rows(n | n >> 1 | n >> 2); };
    const auto all = [](unsigned n) { return first_of_rows(n & n >> 1 & n >> 2); };
    return {any(nine.positive) & any(nine.negative), all(nine.positive) | all(nine.negative)};
  }

  static Lines of_b(const Signs& nine) {
    const auto any = [](unsigned n) { return (n | n >> 3 | n >> 6) & 7; };
    const auto all = [](unsigned n) { return n & n >> 3 & n >> 6 & 7; };
    return {any(nine.positive) & any(nine.negative), all(nine.positive) | all(nine.negative)};
  }
};

/// The determinants whose features certainly are disjoint, or certainly intersect, when the
/// determinant is zero. The signs are those at this time.
struct Meetings {
  unsigned never, always;

  explicit Meetings(const Signs& signs) {
    const Signs heights_a = three(signs, over_b(0)), heights_b = three(signs, over_a(0));
    const Signs nine = {signs.positive >> edges(0, 0), signs.negative >> edges(0, 0)};
    const Lines of_a = Lines::of_a(nine), of_b = Lines::of_b(nine);
    never =
        join(ends_of(of_b.between), ends_of(of_a.between),
             rows(equal(heights_a, next(heights_a))) | columns(equal(heights_b, next(heights_b))));
    always = join(
        ends_of(of_b.piercing), ends_of(of_a.piercing),
        rows(equal(heights_a, -next(heights_a))) & columns(equal(heights_b, -next(heights_b))));
  }

 private:
  static unsigned join(unsigned corners_of_b, unsigned corners_of_a, unsigned pairs_of_edges) {
    return corners_of_b << over_a(0) | corners_of_a << over_b(0) | pairs_of_edges << edges(0, 0);
  }
};

}  // namespace moving
}  // namespace pelt::detail
