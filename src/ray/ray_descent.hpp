#pragma once

/// The door of this room: descents of a posed tree along rays.

#include <pelt/ray.hpp>

#include "base/instruction_set.hpp"
#include "geometry/generic_ray.hpp"
#include "pose/posed_tree.hpp"
#include "query/stack.hpp"

#include <span>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Finds the first hit of each ray.
QueryStats first_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                      std::span<RayHit> hits);

/// Finds whether each ray hits anything.
QueryStats any_hits(const PosedTree& posed, std::span<const Ray> rays, Facing facing,
                    std::span<bool> hit);

/// Writes all hits of a ray to `hits`, in no particular order.
QueryStats all_hits(const PosedTree& posed, const Ray& ray, Facing facing, Stack<RayHit>& hits);

/// Computes the exact winding number of the surface around `point`, along the ray of
/// `geometry/generic_ray.hpp`: the number of triangles that the ray leaves minus the number that it
/// enters. If `point` lies on a triangle, computes the winding number around the point an
/// infinitesimal step away along `direction`. Precondition: the surface is closed.
QueryStats winding_number(const PosedTree& posed, const Vec3& point,
                          const GenericDirection& direction, int& winding);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
