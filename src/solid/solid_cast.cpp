/// A solid is convex, and a capsule consists of two balls and a cylinder between them. A ray is
/// inside each piece for an interval of t. Balls are intersected relative to the ray's point
/// closest to their centre; from far away, the discriminant would suffer from cancellation.

#include <pelt/solid.hpp>

#include "base/require.hpp"
#include "base/vec3.hpp"
#include "query/valid_numbers.hpp"
#include "solid/prepared_region.hpp"

#include <algorithm>
#include <cmath>

namespace pelt {
namespace {

using detail::Vec3d;

/// Interval of t in which a ray is inside; empty unless from <= to.
struct Stay {
  double from = -HUGE_VAL, to = HUGE_VAL;

  /// Restricts the interval to value + t * slope <= 0. Returns whether its start has increased.
  bool keep_below(double value, double slope) {
    if (slope == 0 && value > 0) to = -HUGE_VAL;
    if (slope > 0) to = std::min(to, -value / slope);
    if (!(slope < 0) || -value / slope <= from) return false;
    from = -value / slope;
    return true;
  }
};

struct Line {
  explicit Line(const Ray& ray) : origin(ray.origin), direction(ray.direction) {}

  Vec3d at(double t) const { return origin + t * direction; }

  Vec3d origin, direction;
};

/// Returns the interval with |way + t * direction| <= radius.
Stay stay_near(const Vec3d& way, const Vec3d& direction, double radius) {
  const double speed = squared_length(direction);
  const double closest = speed > 0 ? -dot(way, direction) / speed : 0;
  const double room = radius * radius - squared_length(way + closest * direction);
  if (room < 0) return {HUGE_VAL, -HUGE_VAL};
  if (speed == 0) return {};
  const double half = std::sqrt(room / speed);
  return {closest - half, closest + half};
}

/// Returns the interval within the cylinder between the ends of a capsule.
Stay stay_beside(const Line& line, const Capsule& capsule) {
  const Vec3d edge = Vec3d(capsule.b) - Vec3d(capsule.a), way = line.origin - Vec3d(capsule.a);
  const double length = squared_length(edge);
  if (!(length > 0)) return {HUGE_VAL, -HUGE_VAL};
  const double place = dot(way, edge) / length, slope = dot(line.direction, edge) / length;
  Stay stay = stay_near(way - place * edge, line.direction - slope * edge, double{capsule.radius});
  stay.keep_below(-place, -slope);
  stay.keep_below(place - 1, slope);
  return stay;
}

Vec3 unit(const Vec3d& v) {
  const double length = std::sqrt(squared_length(v));
  return length > 0 ? to_float((1 / length) * v) : Vec3();
}

/// Returns the direction from the closest point of the capsule's segment to `p`.
Vec3 normal_at(const Vec3d& p, const Capsule& capsule) {
  const Vec3d a(capsule.a), edge = Vec3d(capsule.b) - a;
  const double length = squared_length(edge);
  const double share = length > 0 ? std::clamp(dot(p - a, edge) / length, 0.0, 1.0) : 0;
  return unit(p - a - share * edge);
}

/// Updates `hit` if the ray enters a piece earlier. Returns whether the normal must be set.
bool take(const Stay& stay, const Ray& ray, SolidHit& hit) {
  const double t = std::max(stay.from, double{ray.t_min});
  if (!(t <= std::min(stay.to, double{ray.t_max})) || !(t < double{hit.t})) return false;
  hit.t = static_cast<float>(t);
  return stay.from > double{ray.t_min};
}

SolidHit cast_at(const detail::FacesRegion& faces, const Ray& ray) {
  const Line line(ray);
  Stay stay;
  Vec3d normal;
  for (std::uint32_t i = 0; i < faces.count; ++i) {
    const detail::Face& face = faces.exact[i];
    const Vec3d n(face.normal);
    const double value = dot(n, line.origin - Vec3d(face.origin)) - double{face.offset};
    if (stay.keep_below(value, dot(n, line.direction))) normal = n;
  }
  SolidHit hit;
  if (take(stay, ray, hit)) hit.normal = unit(normal);
  return hit;
}

SolidHit cast_at(const Capsule& capsule, const Ray& ray) {
  const Line line(ray);
  SolidHit hit;
  for (const Stay& stay :
       {stay_near(line.origin - Vec3d(capsule.a), line.direction, double{capsule.radius}),
        stay_near(line.origin - Vec3d(capsule.b), line.direction, double{capsule.radius}),
        stay_beside(line, capsule)}) {
    const float before = hit.t;
    const bool enters = take(stay, ray, hit);
    if (hit.t != before) hit.normal = enters ? normal_at(line.at(double{hit.t}), capsule) : Vec3();
  }
  return hit;
}

}  // namespace

QueryStats cast(const Solid& solid, const Ray& ray, SolidHit& result) {
  detail::require(detail::is_valid(ray) && std::isfinite(ray.t_min),
                  "cast: the ray has a NaN or infinite coordinate or start");
  const detail::PreparedRegion prepared(detail::region_of(solid));
  result =
      prepared.is_capsule ? cast_at(prepared.capsule.capsule, ray) : cast_at(prepared.faces, ray);
  return {};
}

}  // namespace pelt
