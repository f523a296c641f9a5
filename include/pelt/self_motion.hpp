#pragma once

/// Continuous self-collision: which triangles of one character intersect each other at any time of
/// a step from one pose to the next, and when first.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/motion.hpp>
#include <pelt/self_collide.hpp>

#include <vector>

namespace pelt {

/// Work of `self_collide_moving`, and the number of pairs that its filters have left out.
struct SelfMovingStats : MovingStats {
  LeftOut left_out;

  PELT_API SelfMovingStats& operator+=(const SelfMovingStats& other);
};

/// Appends every pair of triangles of one character that intersect each other at any time from 0 to
/// 1, in ascending order. In each pair, triangle_a < triangle_b. Pairs that `filter` leaves out are
/// not appended.
///
/// At each time, triangles intersect as defined at `self_collide`, for the positions of the
/// vertices at this time: two corners are shared if they have the same surface vertex, and the same
/// position at this time. The answer is exact, as that of `collide_moving`. With default options,
/// it contains the pairs that `self_collide` finds in the poses at both ends.
///
/// Times and features are those of `collide_moving`, with two differences for triangles that share
/// corners. Features that have a shared corner in common are left out; if only these meet, both
/// features are the whole face. Coplanar triangles can start to overlap right after an instant at
/// which they only fold; the time is then that instant.
///
/// Preconditions:
/// `motion`: a step of the model of `filter`. Otherwise the program aborts, in every build.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: the first query after a new palette poses all vertices and computes all boxes at both
/// ends, O(V + T). Each query descends the tree against itself, and tests all pairs of triangles
/// that share a vertex, eight at a time. Pairs that the filter leaves out cost as much as others.
///
/// Allocates only if it needs more memory in the poses, in `scratch` or in `contacts` than any
/// earlier query.
PELT_API SelfMovingStats self_collide_moving(const Motion& motion, const SelfFilter& filter,
                                             Scratch& scratch, std::vector<MovingContact>& contacts,
                                             const MovingOptions& options = {});

/// Returns whether any triangles of one character intersect each other at any time from 0 to 1.
/// Like `self_collide_moving`, but stops at the first contact that the filter does not leave out.
PELT_API YesNo self_touches_while_moving(const Motion& motion, const SelfFilter& filter,
                                         Scratch& scratch);

}  // namespace pelt
