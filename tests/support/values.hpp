#pragma once

/// Queries that return values, for tests that compare answers and ignore the work.

#include <pelt/pelt.hpp>

namespace pelt::test {

inline Bounds bounds_of(Pose& pose, std::uint32_t levels = 0) {
  Bounds found;
  bounds(pose, found, levels);
  return found;
}

inline Bounds exact_bounds_of(Pose& pose) {
  Bounds found;
  exact_bounds(pose, found);
  return found;
}

inline Box group_box(const Pose& pose, const VertexGroups& groups, std::uint32_t group) {
  Box box;
  group_bounds(pose, groups, group, box);
  return box;
}

inline Box exact_group_box(const Pose& pose, const VertexGroups& groups, std::uint32_t group) {
  Box box;
  exact_group_bounds(pose, groups, group, box);
  return box;
}

inline RayHit first_hit(Pose& pose, const Ray& ray, Facing facing = Facing::both) {
  RayHit hit;
  cast(pose, ray, hit, facing);
  return hit;
}

inline RayHit first_hit(const HeightField& field, const Ray& ray, Facing facing = Facing::both) {
  RayHit hit;
  cast(field, ray, hit, facing);
  return hit;
}

inline SolidHit first_hit(const Solid& solid, const Ray& ray) {
  SolidHit hit;
  cast(solid, ray, hit);
  return hit;
}

inline Placement placement_of(Pose& pose, const Region& region, Scratch& scratch) {
  Placement placement = Placement::outside;
  classify(pose, region, scratch, placement);
  return placement;
}

inline PointSide point_side(Pose& pose, const Vec3& point, Scratch& scratch) {
  PointSide side = PointSide::outside;
  side_of(pose, point, scratch, side);
  return side;
}

inline TrianglesInRegion triangles_in(Pose& pose, const Region& region, Scratch& scratch) {
  TrianglesInRegion found;
  find_triangles(pose, region, scratch, found);
  return found;
}

}  // namespace pelt::test
