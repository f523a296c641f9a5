#include "fuzz/fuzzed_operands.hpp"
#include "fuzz/goal.hpp"
#include "fuzz/questions.hpp"
#include "solid/solids.hpp"
#include "support/require.hpp"

#include <pelt/solid.hpp>

#include <algorithm>
#include <cmath>

namespace pelt::test {
namespace {

using detail::Vec3d;

Goal solids_apart[] = {Goal("distance of a half-space"), Goal("distance of a box"),
                       Goal("distance of an oriented box"), Goal("distance of a sphere"),
                       Goal("distance of a capsule")};
Goal solid_touched("distance of a solid: touching"), solid_hit("cast against a solid: a hit"),
    solid_missed("cast against a solid: a miss"),
    begins_inside("cast against a solid: begins inside");

double largest(const Vec3& v) {
  return std::max({std::abs(double{v.x}), std::abs(double{v.y}), std::abs(double{v.z})});
}

// How far a point is inside a solid: not positive outside, and not further than the surface of the
// solid is away from the point.

double depth_in(const HalfSpace& half, const Vec3d& p) { return -distance_to(half, p); }
double depth_in(const Sphere& sphere, const Vec3d& p) { return -distance_to(sphere, p); }
double depth_in(const Capsule& capsule, const Vec3d& p) { return -distance_to(capsule, p); }

double depth_in(const Box& box, const Vec3d& p) {
  return std::min({p.x - double{box.low.x}, double{box.high.x} - p.x, p.y - double{box.low.y},
                   double{box.high.y} - p.y, p.z - double{box.low.z}, double{box.high.z} - p.z});
}

double depth_in(const OrientedBox& box, const Vec3d& p) {
  const Vec3d way = p - Vec3d(box.centre);
  const auto within = [&](const Vec3& axis, float half) {
    return (double{half} - std::abs(dot(Vec3d(axis), way))) /
           std::sqrt(squared_length(Vec3d(axis)));
  };
  return std::min({within(box.axes[0], box.half.x), within(box.axes[1], box.half.y),
                   within(box.axes[2], box.half.z)});
}

double depth_in(const Solid& solid, const Vec3d& p) {
  return std::visit([&](const auto& shape) { return depth_in(shape, p); }, solid);
}

/// The largest coordinate of a solid and a ray.
double largest_in(const Solid& solid, const Ray& ray) {
  return std::max(detail::extent_of(solid), largest(ray.origin));
}

Vec3d place_at(const Ray& ray, double t) { return Vec3d(ray.origin) + t * Vec3d(ray.direction); }

/// How far rounding of t moves a place along the ray.
double rounding_of(const Ray& ray, double t) {
  return (0x1p-22 * std::abs(t) + 0x1p-149) * std::sqrt(squared_length(Vec3d(ray.direction)));
}

/// Checks that points of the ray before `end` are outside the solid.
void check_outside(const Solid& solid, const Ray& ray, double end, double error) {
  const double begin = double{ray.t_min};
  for (int i = 0; i <= 16; ++i) {
    const double t = i < 16 ? std::min(begin + (end - begin) * i / 16, end) : end;
    require(depth_in(solid, place_at(ray, t)) <= error + rounding_of(ray, t),
            "a ray enters a solid before its hit");
  }
}

void check_hit(const Solid& solid, const Ray& ray, const SolidHit& hit) {
  const double t = double{hit.t};
  const double error = 0x1p-40 * largest_in(solid, ray) + rounding_of(ray, t);
  require(hit.t >= ray.t_min && hit.t <= ray.t_max, "a hit on a solid beyond the ray's ends");
  const double depth = depth_in(solid, place_at(ray, t));
  require(depth >= -error, "a hit outside of a solid");
  if (hit.normal == Vec3()) {
    require(hit.t == ray.t_min, "a hit without a normal after t_min");
    return begins_inside.reach();
  }
  require(depth <= error, "a hit below the surface of a solid");
  check_outside(solid, ray, t, error);
  solid_hit.reach();
}

}  // namespace

void ask_solid_distance(Question& q) {
  const Solid solid = make_solid(q.bytes, q.a);
  const BruteSolidDistance expected = brute_distance(solid, q.a.shape.triangles, q.a.posed);
  SolidDistance found;
  distance(q.a.pose, solid, q.scratch, found);
  require(found.distance == expected.distance, "the distance of a solid");
  require(found.surface.triangle == expected.triangle, "the triangle nearest to a solid");
  distance(q.a.pose, solid, q.scratch, found, {.max_distance = expected.distance});
  require(found.distance == expected.distance, "max_distance of a solid");
  if (expected.distance == 0) return solid_touched.reach();
  distance(q.a.pose, solid, q.scratch, found,
           {.max_distance = std::nextafter(expected.distance, 0.0)});
  require(!found, "a solid beyond max_distance");
  solids_apart[solid.index()].reach();
}

void ask_solid_cast(Question& q) {
  const Solid solid = make_solid(q.bytes, q.a);
  const Ray ray = make_ray(q.bytes, q.b);
  if (!(ray.t_min <= ray.t_max)) return;
  SolidHit hit;
  cast(solid, ray, hit);
  if (hit) return check_hit(solid, ray, hit);
  solid_missed.reach();
  const double end = std::min(double{ray.t_max}, 1e6);
  check_outside(solid, ray, end, 0x1p-40 * largest_in(solid, ray));
}

}  // namespace pelt::test
