#pragma once

/// When a moving triangle first touches a region that stands still.

#include <pelt/motion.hpp>

#include "motion/moving_filter.hpp"
#include "solid/prepared_region.hpp"
#include "solid/region_triangle.hpp"

#include <optional>
#include <span>

namespace pelt::detail {

struct FirstTouch {
  /// The largest float32 that is not above the exact first time.
  float time = 0;

  /// Whether the triangle touches the region at time 0.
  bool at_start = false;

  friend bool operator==(const FirstTouch&, const FirstTouch&) = default;
};

/// Decides exactly whether a closed triangle touches a region at any time from 0 to 1, and when
/// first. At each time, the triangle touches the region as `place_triangle` defines. Its corners
/// move in straight lines between float32 positions, in exact arithmetic.
///
/// Preconditions: those of `place_triangle`. In addition, the coordinates of the triangle are below
/// 2^61.
///
/// Cost: about 100 us. Uses up to 900 KB of the stack. Never allocates.
std::optional<FirstTouch> first_touch(const MovingTriangle& triangle, std::span<const Face> faces);
std::optional<FirstTouch> first_touch(const MovingTriangle& triangle, const Capsule& capsule);

// The stages in double. Precondition: the triangle is apart from the region at time 0.

/// Whether the triangle touches the region at any time.
CertainAnswer certainly_touches(const MovingTriangle& triangle, std::span<const Face> faces);
CertainAnswer certainly_touches(const MovingTriangle& triangle, const Capsule& capsule);

/// Returns false if the first time is not certain. Otherwise sets `touch`.
bool find_certain_first_touch(const MovingTriangle& triangle, std::span<const Face> faces,
                              std::optional<FirstTouch>& touch);
bool find_certain_first_touch(const MovingTriangle& triangle, const Capsule& capsule,
                              std::optional<FirstTouch>& touch);

// Decides about moving triangles and a region one by one, and counts the triangles of each stage.
// Out of line so that these tests are compiled once.

/// Returns when the triangle first touches the region, if ever. Without `options.times`, a touch at
/// any time may be returned, with time 0. With `options.leave_out_start`, returns nothing if the
/// triangle touches the region at time 0.
std::optional<FirstTouch> decide_touch(const FacesRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work);
std::optional<FirstTouch> decide_touch(const CapsuleRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work);

}  // namespace pelt::detail
