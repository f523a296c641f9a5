#include <pelt/farthest.hpp>

#include "base/assert.hpp"
#include "farthest/farthest_search.hpp"
#include "pose/pose.hpp"

#include <cmath>

namespace pelt {

QueryStats farthest_vertex(Pose& pose, const Vec3& direction, FarthestVertex& farthest) {
  PELT_ASSERT(std::isfinite(direction.x) && std::isfinite(direction.y) &&
              std::isfinite(direction.z));
  PELT_ASSERT(direction.x != 0 || direction.y != 0 || direction.z != 0);
  return detail::find_farthest(pose.detail().posed_tree(), direction, farthest);
}

}  // namespace pelt
