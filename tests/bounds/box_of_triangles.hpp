#pragma once

/// The expected bounds, from all posed vertices.

#include <pelt/math.hpp>
#include <pelt/pose.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt::test {

inline std::vector<Vec3> all_posed(const Pose& pose) {
  std::vector<Vec3> positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

/// The empty box, from infinity to minus infinity.
inline Box nothing() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

inline void include(const Vec3& p, Box& box) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}

/// The box of the vertices of these triangles; its zeros are positive.
inline Box box_of(std::span<const Triangle> triangles, std::span<const Vec3> positions) {
  Box box = nothing();
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle) include(positions[v], box);
  for (Vec3* corner : {&box.low, &box.high})
    *corner = {corner->x + 0.0f, corner->y + 0.0f, corner->z + 0.0f};
  return box;
}

inline bool same_bits(const Vec3& a, const Vec3& b) {
  const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

inline bool same_bits(const Box& a, const Box& b) {
  return same_bits(a.low, b.low) && same_bits(a.high, b.high);
}

inline bool encloses(const Box& outer, const Box& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && outer.low.z <= inner.low.z &&
         outer.high.x >= inner.high.x && outer.high.y >= inner.high.y &&
         outer.high.z >= inner.high.z;
}

/// In long double, whose rounding is negligible compared to the margin of a sphere.
inline bool encloses(const Sphere& sphere, const Vec3& p) {
  const auto square = [](float a, float b) {
    const long double d = static_cast<long double>(a) - static_cast<long double>(b);
    return d * d;
  };
  const long double radius = static_cast<long double>(sphere.radius);
  return square(p.x, sphere.centre.x) + square(p.y, sphere.centre.y) +
             square(p.z, sphere.centre.z) <=
         radius * radius;
}

inline bool encloses(const Sphere& sphere, std::span<const Triangle> triangles,
                     std::span<const Vec3> positions) {
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle)
      if (!encloses(sphere, positions[v])) return false;
  return true;
}

}  // namespace pelt::test
