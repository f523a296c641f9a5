#pragma once

/// Descents of a posed tree, still or moving, against a region.

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "motion/moving_tree.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "solid/prepared_region.hpp"

namespace pelt::detail {

struct RegionAnswer {
  bool touches = false;  ///< some triangle touches the region
  bool leaves = false;   ///< some triangle is not wholly inside
  QueryStats work;
};

/// Purpose of a descent.
enum class RegionGoal {
  placement,  ///< whether the surface touches it and leaves it
  touch,      ///< whether the surface touches it
  triangles,  ///< all triangles that touch it, and those inside
};

inline namespace PELT_INSTRUCTION_SET {

/// Writes the requested triangles to `scratch.touching` and `scratch.inside`, in no particular
/// order.
RegionAnswer descend_in_faces(const PosedTree& posed, const FacesRegion& region, Scratch& scratch,
                              RegionGoal goal);
RegionAnswer descend_in_capsule(const PosedTree& posed, const CapsuleRegion& region,
                                Scratch& scratch, RegionGoal goal);

/// Writes at most `options.max_contacts` triangles of a moving tree that touch a region at some
/// time to `scratch.moving`, in no particular order. `triangle_b` and the features have no meaning.
MovingStats descend_moving_in_faces(const MovingTree& moving, const FacesRegion& region,
                                    Scratch& scratch, const MovingOptions& options);
MovingStats descend_moving_in_capsule(const MovingTree& moving, const CapsuleRegion& region,
                                      Scratch& scratch, const MovingOptions& options);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
