#pragma once

/// Rays at a posed mesh: random ones, and the ones that are hardest to decide.

#include "support/random.hpp"

#include <pelt/mesh.hpp>
#include <pelt/ray.hpp>

#include <cmath>
#include <span>

namespace pelt::test {

class RayCases {
 public:
  RayCases(std::span<const Triangle> triangles, std::span<const Vec3> positions)
      : triangles_(triangles), positions_(positions) {
    for (const Vec3& p : positions) {
      low_ = {std::fmin(low_.x, p.x), std::fmin(low_.y, p.y), std::fmin(low_.z, p.z)};
      high_ = {std::fmax(high_.x, p.x), std::fmax(high_.y, p.y), std::fmax(high_.z, p.z)};
    }
  }

  /// A point in the box of the mesh or around it.
  Vec3 place(Random& random) const {
    const auto between = [&](float low, float high) {
      const double size = double{high} - double{low};
      return random.uniformf(double{low} - size, double{high} + size);
    };
    return {between(low_.x, high_.x), between(low_.y, high_.y), between(low_.z, high_.z)};
  }

  const Vec3& vertex(Random& random) const {
    return positions_[triangles_[random.index(size())][random.index(3)]];
  }

  /// A vertex, the middle of an edge up to rounding, or a point inside a triangle.
  Vec3 target(Random& random) const {
    const Triangle& t = triangles_[random.index(size())];
    const Vec3 &a = positions_[t[0]], &b = positions_[t[1]], &c = positions_[t[2]];
    switch (random.index(3)) {
      case 0:
        return a;
      case 1:
        return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
      default:
        return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    }
  }

  Ray next(Random& random) const {
    Ray ray = aimed(random);
    if (random.chance(0.2)) ray = scaled(ray, random);
    if (random.chance(0.2)) limit(ray, random);
    return ray;
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }

  Ray aimed(Random& random) const {
    switch (random.index(6)) {
      case 0:
        return {place(random), random.point(1)};
      case 1:  // from a vertex
        return segment(vertex(random), target(random));
      case 2:
        return along_axis(random);
      case 3: {  // in a plane along an axis
        Ray ray = segment(place(random), target(random));
        component(ray.direction, random.index(3)) = random.chance(0.5) ? 0.0f : -0.0f;
        return ray;
      }
      default: {
        Ray ray = segment(place(random), target(random));
        if (random.chance(0.8)) ray.t_max = std::numeric_limits<float>::infinity();
        return ray;
      }
    }
  }

  /// A ray parallel to an axis, exactly through a target.
  Ray along_axis(Random& random) const {
    const std::uint32_t axis = random.index(3);
    Ray ray = {target(random), {0, 0, 0}};
    const Vec3 start = place(random);
    component(ray.origin, axis) = axis == 0 ? start.x : axis == 1 ? start.y : start.z;
    component(ray.direction, axis) = random.chance(0.5) ? 1.0f : -0.25f;
    return ray;
  }

  static float& component(Vec3& v, std::uint32_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  }

  static Ray scaled(const Ray& ray, Random& random) {
    const float s = std::ldexp(1.0f, static_cast<int>(random.index(120)) - 60);
    const Vec3& d = ray.direction;
    return {ray.origin, {s * d.x, s * d.y, s * d.z}, ray.t_min / s, ray.t_max / s};
  }

  static void limit(Ray& ray, Random& random) {
    const bool is_long = ray.t_max > 1e6f;
    const float unit = is_long ? 1 : ray.t_max;
    ray.t_min = random.uniformf(-2, 1) * unit;
    ray.t_max = random.uniformf(0, 2) * unit;
  }

  std::span<const Triangle> triangles_;
  std::span<const Vec3> positions_;
  Vec3 low_ = {HUGE_VALF, HUGE_VALF, HUGE_VALF}, high_ = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
};

}  // namespace pelt::test
