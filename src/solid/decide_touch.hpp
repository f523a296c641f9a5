#pragma once

/// Decides about moving triangles and a region one by one, and counts the triangles of each stage.
/// Out of line so that these tests are compiled once.

#include <pelt/motion.hpp>

#include "solid/moving_region.hpp"
#include "solid/prepared_region.hpp"

#include <optional>

namespace pelt::detail {

/// Returns when the triangle first touches the region, if ever. Without `options.times`, a touch at
/// any time may be returned, with time 0. With `options.leave_out_start`, returns nothing if the
/// triangle touches the region at time 0.
std::optional<FirstTouch> decide_touch(const FacesRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work);
std::optional<FirstTouch> decide_touch(const CapsuleRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work);

}  // namespace pelt::detail
