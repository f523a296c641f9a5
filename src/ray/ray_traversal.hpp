#pragma once

#include <pelt/ray.hpp>

#include "base/target.hpp"
#include "pose/posed_tree.hpp"
#include "query/stack.hpp"

#include <span>

namespace pelt::detail {
inline namespace PELT_TARGET {

/// What each ray hits first.
QueryStats first_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                      std::span<RayHit> hits);

/// Whether each ray hits anything.
QueryStats any_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                    std::span<bool> hit);

/// Leaves in `hits` all that a ray hits, in no particular order.
QueryStats all_hits(const PosedTree& posed, const Ray& ray, Facing facing, Stack<RayHit>& hits);

/// How often the surface winds around `point`, counted along the ray of `geometry/generic_ray.hpp`:
/// how many triangles it leaves less how many it enters. Exact. Preconditions: the surface is
/// closed, and `point` lies on no triangle.
QueryStats winding_number(const PosedTree& posed, const Vec3& point, int& winding);

}  // namespace PELT_TARGET
}  // namespace pelt::detail
