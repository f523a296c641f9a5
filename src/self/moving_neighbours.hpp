#pragma once

#include <pelt/motion.hpp>

#include "motion/moving_pair.hpp"
#include "self/neighbour_pair.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace pelt::detail {

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

// Decides about moving triangles that share a surface vertex one by one, in double where that is
// certain, and counts the pairs of each stage.

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

/// Tests two triangles of a moving surface that share a surface vertex, in double and then exactly.
/// Returns their contact if they intersect and the options ask for it.
std::optional<MovingContact> decide_neighbours(const MovingSurfaceTriangle& a,
                                               const MovingSurfaceTriangle& b,
                                               const Contact& contact, const MovingOptions& options,
                                               MovingStats& work);

}  // namespace pelt::detail
