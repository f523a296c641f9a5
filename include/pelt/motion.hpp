#pragma once

/// Continuous collision detection: which triangles intersect at any time of a step from one pose to
/// the next, and when first.

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace pelt {

/// A step of one character. Each vertex moves in a straight line, at constant speed, from its
/// posed position in `from` at time 0 to that in `to` at time 1. If the morph weights of both poses
/// are equal, this is the motion of linear blend skinning with linearly blended palettes, up to
/// rounding. Otherwise, the positions between the ends differ from those with blended morph
/// weights.
///
/// In a sequence of frames, use two poses in turn: the `to` of a step is the `from` of the next,
/// and what queries have computed for it remains valid.
///
/// Preconditions: both poses are of one model; otherwise the program aborts, in every build. They
/// may be one pose, which then stands still. Only one thread at a time may use the poses.
struct Motion {
  Pose& from;
  Pose& to;
};

/// A corner of a triangle, an edge with its ends, or the whole triangle.
enum class FeatureKind : std::uint8_t { corner, edge, face };

struct Feature {
  FeatureKind kind = FeatureKind::face;
  std::uint8_t number = 0;  ///< corner i; edge i leads from it to the next corner; 0 for a face

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// Two triangles that intersect at some time of a step.
struct MovingContact {
  Contact contact;

  /// The first time at which the triangles intersect, from 0 to 1, rounded down to a float. The
  /// triangles are apart at all earlier times.
  float time = 0;

  /// Whether the triangles intersect at time 0. The features then have no meaning. Always false in
  /// an answer without times.
  bool at_start = false;

  /// The feature of triangle_a and that of triangle_b that meet at the first time. If several pairs
  /// of features meet, this is the first pair in this order: two corners, a corner and an edge, an
  /// edge and a corner, a corner and a face, a face and a corner, two edges. Of pairs of one kind,
  /// it has the lowest number of a, and of these, the lowest of b.
  Feature a, b;

  friend bool operator==(const MovingContact&, const MovingContact&) = default;
};

struct MovingOptions {
  /// Leaves out pairs that intersect at time 0.
  bool leave_out_start = false;

  /// Whether to compute times and features. If false, each contact has time 0 and features without
  /// meaning, and the query is faster.
  bool times = true;

  /// As in `Limits`. The contacts that are found first need not be the earliest.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();
};

/// Work of a query of motions. A certified test in float decides most pairs of triangles, eight at
/// a time, and a certified test in double decides most of the others. Exact arithmetic decides the
/// rest; it uses up to 260 KB of the stack. For a triangle and a region, there is no test in float,
/// and exact arithmetic uses up to 900 KB.
struct MovingStats : QueryStats {
  std::uint64_t double_pairs = 0;  ///< pairs of triangles tested in double
  std::uint64_t exact_pairs = 0;   ///< of these, pairs tested in exact arithmetic

  PELT_API MovingStats& operator+=(const MovingStats& other);
};

/// Appends every pair of triangles of `a` and `b` that intersect at any time from 0 to 1, in
/// ascending order of the triangles.
///
/// The answer is exact with respect to the float32 posed vertices at both ends (see
/// `posed_vertices`), and to real numbers between them. At each time, triangles intersect as
/// defined at `collide` of two poses, so a body that is wholly inside another one has no contact.
///
/// Preconditions:
/// `a`, `b`: of different poses. A pose in both aborts the program, in every build.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: as `collide` of two poses, but nodes are opened in both poses of a motion, and the number
/// of contacts grows with the distance that the surfaces move into each other.
///
/// Allocates only if it needs more memory in the poses, in `scratch` or in `contacts` than any
/// earlier query.
///
/// Source: Kavan & Zara 2005, section 6, name this query as future work.
PELT_API MovingStats collide(const Motion& a, const Motion& b, Scratch& scratch,
                             std::vector<MovingContact>& contacts,
                             const MovingOptions& options = {});

/// Returns whether any triangles of `a` and `b` intersect at any time from 0 to 1. Like
/// `collide`, but stops at the first contact that it finds.
PELT_API YesNo intersects(const Motion& a, const Motion& b, Scratch& scratch);

/// Sets `first` to the pair of triangles that intersects first. Of pairs with exactly the same
/// first time, it is the lowest. If nothing intersects, `first` is empty. The pair is one of those
/// that `collide` finds, with the same time and features.
///
/// Of `options`, the query uses only `leave_out_start`. Preconditions and allocation: those of
/// `collide`.
///
/// Cost: without `leave_out_start`, first searches for the lowest pair that intersects at time 0.
/// This skips parts of the tree of `a` whose triangles all have higher numbers than the lowest pair
/// found so far. If no pair intersects at time 0, searches the step. This skips parts of the trees
/// whose boxes first overlap after the earliest time found so far.
PELT_API MovingStats first_contact(const Motion& a, const Motion& b, Scratch& scratch,
                                   std::optional<MovingContact>& first,
                                   const MovingOptions& options = {});

}  // namespace pelt
