/// The bounds of a pose, and its farthest vertex.

#include <pelt/bounds.hpp>

#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "bounds/bounds_search.hpp"
#include "exact/exact_determinant.hpp"
#include "model/intervals.hpp"
#include "pose/pose.hpp"
#include "query/valid_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt {
namespace {

/// The radius of a sphere about `centre` that encloses the box. Sums and the root have an error of
/// a few 2^-53, and rounding up to a float makes the radius larger by up to 2^-23.
float radius_of(const Box& box, const Vec3& centre) {
  const auto reach = [](float low, float high, float c) {
    return std::max(static_cast<double>(high) - static_cast<double>(c),
                    static_cast<double>(c) - static_cast<double>(low));
  };
  const detail::Vec3d corner(reach(box.low.x, box.high.x, centre.x),
                             reach(box.low.y, box.high.y, centre.y),
                             reach(box.low.z, box.high.z, centre.z));
  return detail::rounded_up((1 + 0x1p-50) * std::sqrt(detail::squared_length(corner)));
}

float middle(float low, float high) { return low / 2 + high / 2; }

QueryStats bounds_of_levels(Pose& pose, std::uint32_t levels, Bounds& result) {
  const detail::PosedTree posed = pose.detail().posed_tree();
  const detail::BoxFound found = detail::bounding_box(posed, levels);
  const Vec3 low = {found.low[0], found.low[1], found.low[2]};
  const Vec3 high = {found.high[0], found.high[1], found.high[2]};
  const Vec3 centre = {middle(low.x, high.x), middle(low.y, high.y), middle(low.z, high.z)};
  const float around_centre[] = {centre.x, centre.y, centre.z, 0};
  const float of_joints = posed.given
                              ? std::numeric_limits<float>::infinity()
                              : detail::bounding_radius(posed.bounds, posed.palette, around_centre);
  const Box box = {low, high};
  result = {box, {centre, std::min(radius_of(box, centre), of_joints)}};
  return found.work;
}

}  // namespace

QueryStats bounds(Pose& pose, Bounds& result, std::uint32_t levels) {
  return bounds_of_levels(pose, levels, result);
}

QueryStats exact_bounds(Pose& pose, Bounds& result) {
  return bounds_of_levels(pose, std::numeric_limits<std::uint32_t>::max(), result);
}

QueryStats farthest_vertex(Pose& pose, const Vec3& direction, FarthestVertex& farthest) {
  detail::require(detail::is_finite(direction) && !detail::is_zero(direction),
                  "farthest_vertex: the direction is zero, NaN or infinite");
  return detail::find_farthest(pose.detail().posed_tree(), direction, farthest);
}

}  // namespace pelt

namespace pelt::detail {

Vec3 scaled_direction(const Vec3& direction) {
  const float largest =
      std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  const int exponent = -std::ilogb(largest);
  return {std::scalbn(direction.x, exponent), std::scalbn(direction.y, exponent),
          std::scalbn(direction.z, exponent)};
}

/// Products of two floats are exact in double.
int compare_along(const Vec3& direction, const Vec3& p, const Vec3& q) {
  const Vec3d d(direction), a(p), b(q);
  ExactSum<6> sum;
  for (const double term : {d.x * a.x, d.y * a.y, d.z * a.z}) sum.add(term);
  for (const double term : {d.x * b.x, d.y * b.y, d.z * b.z}) sum.add(-term);
  return sum.sign();
}

}  // namespace pelt::detail
