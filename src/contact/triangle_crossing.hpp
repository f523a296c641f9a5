#pragma once

/// How two triangles intersect: which features meet, and where.

#include "geometry/triangle_pair.hpp"

#include <array>
#include <cstdint>

namespace pelt::detail {

/// A corner of a triangle, an edge without its ends, or the interior. Edge i leads from corner i to
/// the next corner.
enum class OpenFeature : std::uint8_t { corner0, corner1, corner2, edge0, edge1, edge2, face };

inline constexpr OpenFeature corner_feature(std::size_t corner) {
  return static_cast<OpenFeature>(corner);
}
inline constexpr OpenFeature edge_feature(std::size_t edge) {
  return static_cast<OpenFeature>(3 + edge);
}

/// An end of the segment in which two triangles intersect, where a feature of one meets a feature
/// of the other: a corner and any feature, two edges, or an edge and a face; never two faces.
struct CrossingEnd {
  OpenFeature a = OpenFeature::face, b = OpenFeature::face;

  friend bool operator==(const CrossingEnd&, const CrossingEnd&) = default;
};

enum class CrossingKind : std::uint8_t {
  none,      ///< they do not intersect
  segment,   ///< their planes cross, and they intersect in a segment
  point,     ///< their planes cross, and they touch in one point: both ends are that
  coplanar,  ///< they intersect in one plane
  collapsed  ///< they intersect, and one of them has collapsed to a segment or a point
};

struct Crossing {
  CrossingKind kind = CrossingKind::none;
  std::array<CrossingEnd, 2> ends;  ///< of a segment or a point, in the direction n_a x n_b of the
                                    ///< normals; meaningless otherwise
};

/// Decides exactly how two closed triangles with float32 coordinates intersect: which features
/// meet, but not where. Agrees with `triangles_intersect`. Precondition: all coordinates are
/// finite.
Crossing cross_triangles(const TriangleCorners& a, const TriangleCorners& b);

/// Returns the position of an end. The position of a corner is exact. A position on an edge is
/// rounded to floats, with an error per coordinate below 2^-23 times the largest coordinate of the
/// two triangles, and has the same bits for all triangles that share the edge. Precondition: the
/// end belongs to the crossing of `a` and `b`.
Vec3 crossing_position(const CrossingEnd& end, const TriangleCorners& a, const TriangleCorners& b);

}  // namespace pelt::detail
