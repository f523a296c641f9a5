#pragma once

/// A region, prepared for the descent in one of two forms, faces or a capsule. Each has a float
/// form for boxes, which may leave a box undecided, and an exact form for triangles.

#include <pelt/solid.hpp>

#include "geometry/triangle_pair.hpp"
#include "solid/region_triangle.hpp"

#include <cstdint>

namespace pelt::detail {

/// A face, scaled by a power of two so that the largest element of its normal is about one.
struct FloatFace {
  float normal[3], origin[3], offset;
};

struct FacesRegion {
  std::uint32_t count = 0;
  Face exact[ConvexPolyhedron::kMaxFaces];
  FloatFace scaled[ConvexPolyhedron::kMaxFaces];

  void add(const Face& face);
};

struct CapsuleRegion {
  Capsule capsule;
  float low[3], high[3];  ///< a box around it
};

/// Tests of a triangle, out of line so that the exact tests are compiled once.
TrianglePlace place_in(const FacesRegion& region, const TriangleCorners& triangle);
TrianglePlace place_in(const CapsuleRegion& region, const TriangleCorners& triangle);

struct PreparedRegion {
  /// Aborts if a number is NaN or infinite, or if a radius or half extent is negative.
  explicit PreparedRegion(const Region& region);

  bool is_capsule = false;
  FacesRegion faces;      ///< unless the region is a capsule
  CapsuleRegion capsule;  ///< if the region is a capsule
};

/// Returns the region of a solid. Aborts if the normal of a half-space is zero, or if a box has its
/// low corner above its high corner.
Region region_of(const Solid& solid);

}  // namespace pelt::detail
