#pragma once

/// Self-collision: which triangles of one character intersect each other, in a pose or at any time
/// of a step. Neighbouring triangles always touch in the corners that they share; this does not
/// count as intersection. A `SelfFilter` (pelt/self_filter.hpp) selects pairs of triangles to leave
/// out of the answer. A `SelfTracker` saves work from one frame to the next.

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/self_filter.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace pelt {

namespace detail {
struct SelfTrack;
}

/// Work of `self_collide`, and the number of pairs that its filters have left out.
struct SelfStats : QueryStats {
  LeftOut left_out;
};

/// Appends the pairs of intersecting triangles of `pose` to `contacts`, in ascending order. In each
/// pair, triangle_a < triangle_b. Corners and edges that two triangles share do not count as
/// intersection. Pairs that `filter` leaves out are not appended.
///
/// Vertices with equal rest positions and the same bits in displacements of morph targets are one
/// surface vertex, whatever their influences. Two triangles share a corner if both have a corner at
/// the same surface vertex and these corners have the same posed position. The number of shared
/// corners decides when two triangles intersect:
/// - 0: if the closed triangles intersect, as in `collide`.
/// - 1: if, in either triangle, the edge opposite the shared corner meets the other closed
///   triangle.
/// - 2: if, in either triangle, the corner that is not shared lies on the other closed triangle.
///   Also if the triangles are folded flat: all corners lie in one plane, and the two corners that
///   are not shared lie strictly on the same side of the shared edge.
/// - 3: always, because the triangles are duplicates.
///
/// Equal corners of a triangle count as one corner. In a triangle with the corners p, p and q, the
/// point q is opposite the corner p, instead of an edge. Two triangles are duplicates if each
/// shares all of its corners with the other.
///
/// The answer is exact with respect to the float32 posed vertices (see `posed_vertices`). A
/// triangle that has collapsed to a segment or a point is treated as that segment or point.
///
/// Preconditions:
/// `filter`: made for the model of `pose`. Otherwise the program aborts, in every build.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: the first query after a new palette poses all vertices and computes all boxes, O(V + T).
/// Each query also descends the tree against itself, which alone costs time proportional to T,
/// because neighbours always touch. Pairs that the filter leaves out cost as much as others. If
/// `rings` is more than 1, each intersecting pair also costs O(triangles in the rings).
///
/// Allocates only if it needs more memory in the pose, in `scratch` or in `contacts` than any
/// earlier query.
PELT_API SelfStats self_collide(Pose& pose, const SelfFilter& filter, Scratch& scratch,
                                std::vector<Contact>& contacts, const Limits& limits = {});

/// Returns whether any triangles of `pose` intersect each other. Like `self_collide`, but stops at
/// the first contact that the filter does not leave out.
PELT_API YesNo self_intersects(Pose& pose, const SelfFilter& filter, Scratch& scratch);

/// Results of earlier frames that remain valid for similar poses. Create one tracker per instance,
/// and use it for every frame. Poses may follow each other in any order, but a tracker saves time
/// only if a pose is similar to the previous one.
class PELT_API SelfTracker {
 public:
  /// Shares `filter`.
  ///
  /// Cost: O(T log T). Allocates.
  explicit SelfTracker(const SelfFilter& filter);
  SelfTracker(SelfTracker&&) noexcept;
  SelfTracker& operator=(SelfTracker&&) noexcept;
  ~SelfTracker();

  const SelfFilter& filter() const;

  /// Bytes of memory, without the filter: about 30 bytes per triangle.
  std::size_t memory_bytes() const;

  /// For internal use.
  detail::SelfTrack& detail() { return *track_; }

 private:
  std::unique_ptr<detail::SelfTrack> track_;
};

/// Appends the same contacts as `self_collide` with `tracker.filter()`, in the same order. If
/// `max_contacts` ends the query early, the contacts may differ from those found without a tracker.
///
/// Preconditions:
/// `tracker`: its filter was made for the model of `pose`. Otherwise the program aborts, in every
///   build. Not used by another thread at the same time.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: less than `self_collide` without a tracker if the surface moves almost rigidly with its
/// joints. Neighbouring parts of the surface are then tested again only after they have moved so
/// far, relative to a joint, that their triangles might intersect. The first call, and a call after
/// a large change, cost up to twice as much as `self_collide` without a tracker.
///
/// Allocates only if it needs more memory in the pose, in `scratch` or in `contacts` than any
/// earlier query.
PELT_API SelfStats self_collide(Pose& pose, SelfTracker& tracker, Scratch& scratch,
                                std::vector<Contact>& contacts, const Limits& limits = {});

/// Work of `self_collide` of a motion, and the number of pairs that its filters have left out.
struct SelfMovingStats : MovingStats {
  LeftOut left_out;

  PELT_API SelfMovingStats& operator+=(const SelfMovingStats& other);
};

/// Appends every pair of triangles of one character that intersect each other at any time from 0 to
/// 1, in ascending order. In each pair, triangle_a < triangle_b. Pairs that `filter` leaves out are
/// not appended.
///
/// At each time, triangles intersect as defined at `self_collide` of a pose, for the positions of
/// the vertices at this time: two corners are shared if they have the same surface vertex, and the
/// same position at this time. The answer is exact, as that of `collide` of motions. With default
/// options, it contains the pairs that `self_collide` finds in the poses at both ends.
///
/// Times and features are those of `collide` of motions, with two differences for triangles that
/// share corners. Features that have a shared corner in common are left out; if only these meet,
/// both features are the whole face. Coplanar triangles can start to overlap right after an instant
/// at which they only fold; the time is then that instant.
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
PELT_API SelfMovingStats self_collide(const Motion& motion, const SelfFilter& filter,
                                      Scratch& scratch, std::vector<MovingContact>& contacts,
                                      const MovingOptions& options = {});

/// Returns whether any triangles of one character intersect each other at any time from 0 to 1.
/// Like `self_collide`, but stops at the first contact that the filter does not leave out.
PELT_API YesNo self_intersects(const Motion& motion, const SelfFilter& filter, Scratch& scratch);

}  // namespace pelt
