#pragma once

/// Distances of posed surfaces from points and from each other.
///
/// Distances are in model units. A surface is not a solid: if one body is inside another without
/// touching it, their distance is positive. For a rigid or static mesh, build a model with one
/// joint.
///
/// Exactness: without a tolerance, answers depend only on the float32 posed vertices (see
/// `posed_vertices`), and not on earlier queries or on the machine. The distance of two triangles
/// is 0 if and only if they intersect as in `collide`, which is decided exactly. Otherwise the
/// distance is computed in double and is positive. Of triangles whose computed distances are equal,
/// those with the lowest indices are reported.
///
/// Error: less than 2^-46 s, where s is the longest side of the axis-aligned box around the two
/// triangles. docs/queries.md ("Errors of distances") has a second bound, for triangles whose
/// boxes are apart.
///
/// Cost: queries visit the boxes of a tree in ascending order of distance. A node is opened only if
/// its box is closer than the closest triangles found so far.
///
/// Source: branch and bound after Quinlan, "Efficient distance computation between non-convex
/// objects", 1994. Computing boxes on demand is section 4.2 of Kavan & Zara 2005.

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt {

/// A point of a posed surface.
struct SurfacePoint {
  std::uint32_t triangle = 0;  ///< index into the model's triangle array

  /// Weights of the three vertices of the triangle. The sum is 1 up to rounding.
  std::array<float, 3> barycentrics = {};

  Vec3 position;  ///< rounded to float
};

/// Result of `closest_point`.
struct ClosestPoint {
  /// Infinite if nothing is within `max_distance`; `point` is then meaningless.
  double distance = std::numeric_limits<double>::infinity();
  SurfacePoint point;

  /// Whether anything was found.
  explicit operator bool() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// Writes the point of the posed surface that is closest to `point`. The distance of a point on the
/// surface may be slightly more than 0.
///
/// Error: let s be the longest side of the axis-aligned box around the point and one triangle. The
/// error of their distance is less than 2^-46 s.
///
/// Precondition: the coordinates of `point` are between -2^60 and 2^60. A NaN or infinite
/// coordinate aborts the program, in every build.
///
/// Cost: grows with the number of triangles that are about as close as the closest point. Allocates
/// only if it needs more memory in the pose or in `scratch` than any earlier query.
PELT_API QueryStats closest_point(Pose& pose, const Vec3& point, Scratch& scratch,
                                  ClosestPoint& result, const Limits& limits = {});

/// Writes the closest point for each of `points`. Nodes that one point opens stay open for all
/// later points.
///
/// Precondition: `results` has one element per point. Otherwise the program aborts, in every build.
PELT_API QueryStats closest_points(Pose& pose, std::span<const Vec3> points, Scratch& scratch,
                                   std::span<ClosestPoint> results, const Limits& limits = {});

/// Result of `distance`.
struct Distance {
  /// Distance of the points `a` and `b`. Infinite if nothing is within `max_distance`; `a` and `b`
  /// are then meaningless.
  double distance = std::numeric_limits<double>::infinity();

  /// Proven lower bound of the least distance: `distance` minus the tolerance, and at least 0; or
  /// `max_distance` if nothing is within it. If `DistanceOptions::max_work` cut the query short, it
  /// may be less.
  double lower_bound = 0;

  SurfacePoint a, b;

  /// Whether anything was found.
  explicit operator bool() const { return distance < std::numeric_limits<double>::infinity(); }

  /// For `DistanceOptions::hint`.
  TreeLocation<4> location;
};

struct DistanceOptions {
  /// Ignore everything farther away. A negative or NaN value aborts the program, in every build.
  double max_distance = std::numeric_limits<double>::infinity();

  /// Greatest allowed difference between the result and the least distance. A positive tolerance
  /// lets the query end earlier; the result may then depend on earlier queries. A negative or NaN
  /// value aborts the program, in every build.
  double tolerance = 0;

  /// An earlier result for the same two models in nearly the same poses, or null. The search starts
  /// at the triangles of that result. If the tolerance is 0, answers do not depend on the hint.
  const Distance* hint = nullptr;

  /// Stop after about this many units of work (`work_of`). `QueryStats::cut_short` then says that
  /// the result is an interval: see `Distance::lower_bound`. The distance from a height field
  /// ignores this limit. docs/queries.md ("A distance with a limit of the work") says what it
  /// depends on.
  std::uint64_t max_work = std::numeric_limits<std::uint64_t>::max();
};

/// Writes the least distance between a triangle of `a` and a triangle of `b`, and two points at
/// this distance.
///
/// Precondition: `a` and `b` are different poses, of one model or of two. Passing one pose twice
/// aborts the program, in every build.
///
/// Cost: grows with the parts of the surfaces that are about as close as the closest points. If the
/// poses touch, the query costs as much as `collide`, because it finds all touching pairs and
/// reports the lowest pair. With a positive tolerance, poses that touch cost as much as
/// `intersects`.
///
/// Allocates only if it needs more memory in the poses or in `scratch` than any earlier query.
PELT_API QueryStats distance(Pose& a, Pose& b, Scratch& scratch, Distance& result,
                             const DistanceOptions& options = {});

/// Appends every pair of triangles of `a` and `b` whose distance is at most `tolerance`, in
/// ascending order. With a tolerance of 0, these are the pairs of `collide`.
///
/// Preconditions:
/// `a`, `b`: different poses, as for `distance`.
/// `tolerance`: neither negative nor NaN. Otherwise the program aborts, in every build.
///
/// Cost: grows with the parts of the surfaces that are within the tolerance.
///
/// Allocates only if it needs more memory in the poses, in `scratch` or in `pairs` than any earlier
/// query.
PELT_API QueryStats clearance(Pose& a, Pose& b, double tolerance, Scratch& scratch,
                              std::vector<Contact>& pairs, const Limits& limits = {});

/// Returns whether any triangle of `a` is within `tolerance` of any triangle of `b`. Like
/// `clearance`, with the same preconditions, but stops at the first pair.
PELT_API YesNo is_within(Pose& a, Pose& b, double tolerance, Scratch& scratch);

}  // namespace pelt
