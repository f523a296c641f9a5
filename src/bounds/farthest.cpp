#include <pelt/bounds.hpp>

#include "base/require.hpp"
#include "base/vec3.hpp"
#include "bounds/farthest_search.hpp"
#include "exact/exact_determinant.hpp"
#include "pose/pose.hpp"
#include "query/valid_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace pelt {

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
