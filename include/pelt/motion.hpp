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

  /// The largest float that is not above the first time at which the triangles intersect, as a part
  /// of the step: 0 to 1. The triangles are apart at all earlier times.
  float time = 0;

  /// Whether the triangles intersect at time 0. The features then have no meaning. Always false in
  /// an answer without times.
  bool at_start = false;

  /// Which parts of triangle_a and triangle_b meet at the first time. Of all pairs that meet, this
  /// is the first one in this order: two corners, a corner and an edge, an edge and a corner, a
  /// corner and a face, a face and a corner, two edges; then the lowest number of a, then of b.
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

/// Work of a query of motions. A certified test in float decides most pairs of triangles in groups
/// of eight, and a slower one in double most others. Exact arithmetic decides the rest, and uses up
/// to 260 KB of the stack, or 900 KB for a triangle and a region. Triangles and regions have no
/// test in float.
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

/// Sets `first` to the pair of triangles with the least exact first time; of pairs with exactly the
/// same time, to the lowest. If nothing intersects, `first` is empty. The pair is one of those that
/// `collide` finds, with the same time and features.
///
/// Of `options`, only `leave_out_start` applies. Preconditions and allocation: those of `collide`.
///
/// Cost: looks for the lowest pair at time 0 first, and skips parts of a's tree whose triangles all
/// have higher numbers than those of the lowest pair found so far. If nothing intersects at time 0,
/// the query continues with the step, and skips parts of the trees whose boxes first overlap after
/// the earliest time found so far.
PELT_API MovingStats first_contact(const Motion& a, const Motion& b, Scratch& scratch,
                                   std::optional<MovingContact>& first,
                                   const MovingOptions& options = {});

}  // namespace pelt
