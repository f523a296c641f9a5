#pragma once

/// Solids of all kinds, and brute force over triangles.

#include "solid/region_oracle.hpp"
#include "solid/solid_distance.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/solid.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

namespace pelt::test {

/// A random solid near `about`, of about the given size.
inline Solid random_solid(Random& random, const Vec3& about, double size) {
  const auto point = [&] {
    const Vec3 away = random.point(size);
    return Vec3{about.x + away.x, about.y + away.y, about.z + away.z};
  };
  const auto length = [&] { return random.chance(0.2) ? 0 : random.uniformf(0, size / 2); };
  const Vec3 centre = point(), half = {length(), length(), length()};
  switch (random.index(5)) {
    case 0: {
      const Vec3 n = random.point(2);
      return HalfSpace{n, n.x * centre.x + n.y * centre.y + n.z * centre.z};
    }
    case 1:
      return Box{{centre.x - half.x, centre.y - half.y, centre.z - half.z},
                 {centre.x + half.x, centre.y + half.y, centre.z + half.z}};
    case 2: {
      const Matrix4 turn = rotation_about(random.point(1), random.uniform(0, 3), {}, {});
      OrientedBox box{centre, {}, half};
      for (std::size_t i = 0; i < 3; ++i)
        box.axes[i] = {turn.m[4 * i], turn.m[4 * i + 1], turn.m[4 * i + 2]};
      return box;
    }
    case 3:
      return Sphere{centre, length()};
    default:
      return Capsule{centre, point(), length()};
  }
}

inline bool touches(const Solid& solid, const detail::TriangleCorners& triangle) {
  const Region region = std::visit([](const auto& shape) { return Region(shape); }, solid);
  return place_of(detail::PreparedRegion(region), triangle) != detail::TrianglePlace::apart;
}

struct BruteSolidDistance {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = 0;
};

inline BruteSolidDistance brute_distance(const Solid& solid, std::span<const Triangle> triangles,
                                         std::span<const Vec3> positions) {
  BruteSolidDistance best;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    const detail::TriangleCorners corners = {positions[a], positions[b], positions[c]};
    const double distance =
        touches(solid, corners) ? 0 : detail::closest_points(corners, solid).distance;
    if (distance < best.distance) best = {distance, t};
  }
  return best;
}

// The distance of a point from each kind of solid, by other formulas.

inline double distance_to(const HalfSpace& half, const detail::Vec3d& p) {
  const detail::Vec3d n(half.normal);
  return (dot(n, p) - double{half.offset}) / std::sqrt(detail::squared_length(n));
}

inline double distance_to(const Capsule& capsule, const detail::Vec3d& p) {
  const detail::Vec3d a(capsule.a), edge = detail::Vec3d(capsule.b) - a;
  const double length = detail::squared_length(edge);
  const double share = length > 0 ? std::clamp(dot(p - a, edge) / length, 0.0, 1.0) : 0;
  return std::sqrt(detail::squared_length(p - a - share * edge)) - double{capsule.radius};
}

inline double distance_to(const Sphere& sphere, const detail::Vec3d& p) {
  return distance_to(Capsule{sphere.centre, sphere.centre, sphere.radius}, p);
}

/// Precondition: the axes are orthogonal.
inline double distance_to(const OrientedBox& box, const detail::Vec3d& p) {
  const detail::Vec3d way = p - detail::Vec3d(box.centre);
  const auto beyond = [&](std::size_t axis, float half) {
    return std::max(std::abs(dot(detail::Vec3d(box.axes[axis]), way)) - double{half}, 0.0);
  };
  return std::sqrt(detail::squared_length(
      {beyond(0, box.half.x), beyond(1, box.half.y), beyond(2, box.half.z)}));
}

inline double distance_to(const Box& box, const detail::Vec3d& p) {
  const auto beyond = [](double low, double high, double place) {
    return std::max({low - place, place - high, 0.0});
  };
  return std::sqrt(detail::squared_length({beyond(box.low.x, box.high.x, p.x),
                                           beyond(box.low.y, box.high.y, p.y),
                                           beyond(box.low.z, box.high.z, p.z)}));
}

inline double distance_to(const Solid& solid, const detail::Vec3d& p) {
  return std::visit([&](const auto& shape) { return distance_to(shape, p); }, solid);
}

}  // namespace pelt::test
