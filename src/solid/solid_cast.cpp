/// A solid is convex, and a capsule consists of two balls and a cylinder between them. A ray is
/// inside each piece for an interval of t. Balls are intersected relative to the ray's point
/// closest to their centre; from far away, the discriminant would suffer from cancellation.

#include <pelt/solid.hpp>

#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "query/valid_numbers.hpp"
#include "solid/prepared_region.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace pelt {
namespace {

using detail::Vec3d;

/// Interval of t in which a ray is inside; empty unless from <= to.
struct Stay {
  double from = -HUGE_VAL, to = HUGE_VAL;
  Vec3d out;  ///< the direction out of the solid where the ray enters, of any length

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

  Vec3d origin, direction;
};

/// Returns the interval with |way + t * direction| <= radius. A ball without a radius has every
/// direction as a normal; this chooses the one against the ray.
Stay stay_near(const Vec3d& way, const Vec3d& direction, double radius) {
  const double speed = squared_length(direction);
  const double closest = speed > 0 ? -dot(way, direction) / speed : 0;
  const Vec3d passing = way + closest * direction;
  const double room = radius * radius - squared_length(passing);
  if (room < 0) return {HUGE_VAL, -HUGE_VAL, {}};
  if (speed == 0) return {-HUGE_VAL, HUGE_VAL, passing};
  const double half = std::sqrt(room / speed);
  const Vec3d out = radius > 0 ? passing - half * direction : -1.0 * direction;
  return {closest - half, closest + half, out};
}

/// Returns the interval within the cylinder between the ends of a capsule. Its flat ends are in the
/// balls, so a ray enters there only by rounding, at the rim, where the normal is that of the side;
/// or along a capsule without a radius.
Stay stay_beside(const Line& line, const Capsule& capsule) {
  const Vec3d edge = Vec3d(capsule.b) - Vec3d(capsule.a), way = line.origin - Vec3d(capsule.a);
  const double length = squared_length(edge);
  if (!(length > 0)) return {HUGE_VAL, -HUGE_VAL, {}};
  const double place = dot(way, edge) / length, slope = dot(line.direction, edge) / length;
  Stay stay = stay_near(way - place * edge, line.direction - slope * edge, double{capsule.radius});
  stay.keep_below(-place, -slope);
  stay.keep_below(place - 1, slope);
  if (!(squared_length(stay.out) > 0)) stay.out = -1.0 * line.direction;
  return stay;
}

Vec3 unit(const Vec3d& v) {
  const double length = std::sqrt(squared_length(v));
  return length > 0 ? to_float((1 / length) * v) : Vec3();
}

/// Returns the first of the entries into the pieces of a solid. If the ray begins in any piece, the
/// normal is zero.
SolidHit first_entry(std::initializer_list<Stay> pieces, const Ray& ray) {
  constexpr double kLongest = std::numeric_limits<float>::max();
  SolidHit hit;
  double first = HUGE_VAL;
  for (const Stay& stay : pieces) {
    const double t = std::max(stay.from, double{ray.t_min});
    if (!(t <= std::min({stay.to, double{ray.t_max}, kLongest})) || !(t < first)) continue;
    first = t;
    hit.t = static_cast<float>(t);
    hit.normal = stay.from > double{ray.t_min} ? unit(stay.out) : Vec3();
  }
  return hit;
}

SolidHit cast_at(const detail::FacesRegion& faces, const Ray& ray) {
  const Line line(ray);
  Stay stay;
  for (std::uint32_t i = 0; i < faces.count; ++i) {
    const detail::Face& face = faces.exact[i];
    const Vec3d n(face.normal);
    const double value = dot(n, line.origin - Vec3d(face.origin)) - double{face.offset};
    if (stay.keep_below(value, dot(n, line.direction))) stay.out = n;
  }
  return first_entry({stay}, ray);
}

SolidHit cast_at(const Capsule& capsule, const Ray& ray) {
  const Line line(ray);
  const double radius{capsule.radius};
  return first_entry({stay_near(line.origin - Vec3d(capsule.a), line.direction, radius),
                      stay_near(line.origin - Vec3d(capsule.b), line.direction, radius),
                      stay_beside(line, capsule)},
                     ray);
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
