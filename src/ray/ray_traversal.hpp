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

}  // namespace PELT_TARGET
}  // namespace pelt::detail
