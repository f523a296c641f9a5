#include <pelt/farthest.hpp>

#include "base/require.hpp"
#include "farthest/farthest_search.hpp"
#include "pose/pose.hpp"
#include "query/valid_numbers.hpp"

namespace pelt {

QueryStats farthest_vertex(Pose& pose, const Vec3& direction, FarthestVertex& farthest) {
  detail::require(detail::is_finite(direction) && !detail::is_zero(direction),
                  "farthest_vertex: the direction is zero, NaN or infinite");
  return detail::find_farthest(pose.detail().posed_tree(), direction, farthest);
}

}  // namespace pelt
