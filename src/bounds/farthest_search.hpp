#pragma once

#include <pelt/bounds.hpp>

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {

/// `direction` times a power of two: its largest component is in [1, 2).
Vec3 scaled_direction(const Vec3& direction);

/// The exact sign of dot(direction, p) - dot(direction, q).
int compare_along(const Vec3& direction, const Vec3& p, const Vec3& q);

inline namespace PELT_INSTRUCTION_SET {

/// Finds the vertex of a triangle that is farthest along `direction`, and stores it in `farthest`.
QueryStats find_farthest(const PosedTree& posed, const Vec3& direction, FarthestVertex& farthest);

}  // namespace PELT_INSTRUCTION_SET

}  // namespace pelt::detail
