#pragma once

/// Exact tests of a triangle, still or moving, against a convex polyhedron, given by its faces, and
/// a capsule.

#include <pelt/math.hpp>
#include <pelt/motion.hpp>

#include "geometry/triangle_pair.hpp"
#include "motion/moving_filter.hpp"

#include <optional>
#include <span>

namespace pelt::detail {

/// All points p with normal . (p - origin) <= offset.
struct Face {
  Vec3 normal, origin;
  float offset = 0;
};

enum class TrianglePlace { apart, touching, inside };

/// Returns where a closed triangle lies with respect to the intersection of half-spaces. `touching`
/// means touching but not inside. Precondition: all numbers are finite, and there are at most
/// kMaxFaces faces.
TrianglePlace place_triangle(const TriangleCorners& triangle, std::span<const Face> faces);

/// Returns exactly where a closed triangle lies with respect to a capsule. A sphere is a capsule
/// with equal ends. Precondition: all numbers are finite, and the radius is not negative.
TrianglePlace place_triangle(const TriangleCorners& triangle, const Capsule& capsule);

/// The first time at which a moving triangle touches a region that stands still.
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

struct FacesRegion;
struct CapsuleRegion;

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
