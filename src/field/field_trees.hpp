#pragma once

/// The queries of a tree and a height field. This room has no door: nothing outside uses it.

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "distance/distance_search.hpp"
#include "field/height_field.hpp"
#include "motion/moving_tree.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `max_contacts` pairs of intersecting triangles of the pose and the field to
/// `scratch.found`, in no particular order.
QueryStats collide_field(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts);

/// Writes at most `options.max_contacts` pairs of triangles of a moving tree and the field that
/// intersect at some time to `scratch.moving`, in no particular order.
MovingStats collide_moving_field(const MovingTree& moving, const HeightField& field,
                                 Scratch& scratch, const MovingOptions& options);

/// Finds the least distance of a pose and a field that do not touch, like `closest_triangles` for
/// two poses. The first two slots are the cluster, the third is a block of the lowest level.
QueryStats closest_field_triangle(const PosedTree& posed, const HeightField& field,
                                  Scratch& scratch, const SearchLimits& limits,
                                  TriangleGap& closest);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
