#pragma once

/// A region as the descent needs it: in two forms, of faces and of a capsule, each with a float
/// form for boxes, which may leave a box undecided, and the exact one for triangles.

#include <pelt/region.hpp>

#include "geometry/faces_triangle.hpp"
#include "geometry/triangle_pair.hpp"

#include <cstdint>

namespace pelt::detail {

/// A face scaled by a power of two, so that its normal's largest element is about one.
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

/// What is asked of a triangle, out of line: the exact tests are compiled once.
TrianglePlace place_in(const FacesRegion& region, const TriangleCorners& triangle);
TrianglePlace place_in(const CapsuleRegion& region, const TriangleCorners& triangle);

struct PreparedRegion {
  /// Precondition: finite numbers, radii and half extents not negative.
  explicit PreparedRegion(const Region& region);

  bool is_capsule = false;
  FacesRegion faces;      ///< if it is none
  CapsuleRegion capsule;  ///< if it is one
};

}  // namespace pelt::detail
