#pragma once

#include "geometry/triangle_pair.hpp"

#include <array>
#include <cstdint>

namespace pelt::detail {

/// A corner of a triangle, an edge without its ends, or all within the edges. Edge i leads from
/// corner i to the next.
enum class Feature : std::uint8_t { corner0, corner1, corner2, edge0, edge1, edge2, face };

inline constexpr Feature corner_feature(std::size_t corner) { return static_cast<Feature>(corner); }
inline constexpr Feature edge_feature(std::size_t edge) { return static_cast<Feature>(3 + edge); }

/// An end of the segment in which two triangles intersect: the place where a feature of one meets a
/// feature of the other. Corner and anything, edge and edge, or edge and face: never face and face.
struct CrossingEnd {
  Feature a = Feature::face, b = Feature::face;

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

/// How two closed triangles intersect, decided exactly on their float32 coordinates: which features
/// meet, not where. Agrees with `triangles_intersect`. Precondition: all coordinates are finite.
Crossing cross_triangles(const TriangleCorners& a, const TriangleCorners& b);

/// Where an end is. A corner is where it is; a place on an edge is rounded to floats, each
/// coordinate off by less than 2^-23 times the largest coordinate of the two triangles. The same to
/// the bit for all triangles that share the edge. Precondition: the end is one of their crossing.
Vec3 crossing_position(const CrossingEnd& end, const TriangleCorners& a, const TriangleCorners& b);

}  // namespace pelt::detail
