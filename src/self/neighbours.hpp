#pragma once

/// Exact tests of two triangles of one surface that may share corners, still and moving.

#include <pelt/motion.hpp>

#include "geometry/triangle_pair.hpp"
#include "motion/moving_pair.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace pelt::detail {

/// A posed triangle with the surface vertices of its corners.
struct SurfaceTriangle {
  TriangleCorners corners;
  std::array<std::uint32_t, 3> vertices;
};

/// Whether two triangles of one surface intersect, apart from the corners that they share. Two
/// corners are shared if they have the same surface vertex and the same position. A crack opens
/// between two corners with the same surface vertex and different positions: these are not shared.
///
/// Decided exactly, by the number of distinct corners that the triangles share:
///
///   none    the closed triangles intersect
///   one     the edge opposite the shared corner, of one triangle, meets the other closed triangle
///   two     the triangles are folded flat: all corners lie in one plane, and the two corners that
///           are not shared lie strictly on the same side of the shared edge; or the third corner
///           of one triangle lies on the other closed triangle
///   all     always: the triangles are duplicates
///
/// A triangle with equal corners, such as (p, p, q), has two distinct corners or one. The edge
/// opposite p is then the point q; there may also be no such edge, or no third corner. A triangle
/// that has collapsed is treated as a segment or a point. The answer is symmetric and does not
/// depend on the order of the corners. Precondition: all coordinates are finite.
bool surface_triangles_intersect(const SurfaceTriangle& a, const SurfaceTriangle& b);

/// A moving triangle with the surface vertices of its corners.
struct MovingSurfaceTriangle {
  MovingTriangle corners;
  std::array<std::uint32_t, 3> vertices;
};

/// Decides exactly whether two triangles of one moving surface intersect at any time from 0 to 1,
/// and when first. At each time, they intersect as `surface_triangles_intersect` defines, and two
/// corners are shared if they have the same surface vertex and are at one position at this time.
///
/// The set of times need not be closed: triangles that are coplanar and folded open may begin to
/// overlap after an instant at which they do not. `time` then belongs to this instant, and the
/// triangles intersect immediately after it.
///
/// Of the features, those that have a shared corner in common are left out. If no pair of others
/// meets, both features are whole triangles.
///
/// Cost and preconditions: those of `first_meeting`.
std::optional<FirstMeeting> first_meeting_of_neighbours(const MovingSurfaceTriangle& a,
                                                        const MovingSurfaceTriangle& b);

/// Whether two triangles of a moving surface certainly never intersect, as
/// `first_meeting_of_neighbours` decides. Computes in double. Precondition: that of
/// `first_meeting`.
bool certainly_apart(const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b);

/// The corners that two triangles share, by number: first the shared ones, in the same order for a
/// and b, then the others.
struct SharedCorners {
  std::array<std::uint8_t, 3> a = {0, 1, 2}, b = {0, 1, 2};
  std::uint32_t count = 0;

  /// `are_one(i, k)`: whether corner i of a and corner k of b are one corner. Precondition: a
  /// corner is shared with at most one.
  template <typename AreOne>
  explicit SharedCorners(const AreOne& are_one) {
    for (std::uint8_t i = 0; i < 3; ++i)
      for (std::uint8_t k = 0; k < 3; ++k)
        if (are_one(i, k)) add(i, k);
  }

 private:
  void add(std::uint8_t i, std::uint8_t k) {
    move_to(a, count, i);
    move_to(b, count, k);
    ++count;
  }

  static void move_to(std::array<std::uint8_t, 3>& order, std::uint32_t place,
                      std::uint8_t corner) {
    for (std::uint32_t i = place; i < 3; ++i)
      if (order[i] == corner) std::swap(order[i], order[place]);
  }
};

/// Tests two triangles of a moving surface that share a surface vertex, in double and, where that
/// is not certain, exactly. Counts the pairs of each stage. Returns the contact if the triangles
/// intersect and the options do not leave it out.
std::optional<MovingContact> decide_neighbours(const MovingSurfaceTriangle& a,
                                               const MovingSurfaceTriangle& b,
                                               const Contact& contact, const MovingOptions& options,
                                               MovingStats& work);

}  // namespace pelt::detail
