#pragma once

/// Tests all posed or moving triangles against a region, one by one.

#include <pelt/solid.hpp>

#include "solid/prepared_region.hpp"
#include "solid/region_triangle.hpp"

#include <span>
#include <vector>

namespace pelt::test {

inline detail::TrianglePlace place_of(const detail::PreparedRegion& region,
                                      const detail::TriangleCorners& triangle) {
  return region.is_capsule ? place_in(region.capsule, triangle) : place_in(region.faces, triangle);
}

inline TrianglesInRegion brute_force(const Region& region, std::span<const Triangle> triangles,
                                     std::span<const Vec3> positions) {
  const detail::PreparedRegion prepared(region);
  TrianglesInRegion found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    const auto place = place_of(prepared, {positions[a], positions[b], positions[c]});
    if (place == detail::TrianglePlace::apart) continue;
    found.intersecting.push_back(t);
    if (place == detail::TrianglePlace::inside) found.inside.push_back(t);
  }
  return found;
}

/// The triangles that touch the region while they move.
inline std::vector<RegionEntry> brute_force_moving(
    const Region& region, std::span<const detail::MovingTriangle> triangles) {
  const detail::PreparedRegion prepared(region);
  const std::span faces(prepared.faces.exact, prepared.faces.count);
  std::vector<RegionEntry> entries;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    if (const auto touch = prepared.is_capsule
                               ? detail::first_touch(triangles[i], prepared.capsule.capsule)
                               : detail::first_touch(triangles[i], faces))
      entries.push_back({i, touch->time, touch->at_start});
  return entries;
}

inline Placement placement_of(const TrianglesInRegion& found, std::size_t triangle_count) {
  if (found.intersecting.empty()) return Placement::outside;
  return found.inside.size() == triangle_count ? Placement::inside : Placement::partly;
}

}  // namespace pelt::test
