#pragma once

/// How far posed surfaces are from points and from each other.
///
/// Exact means here: the answer is that of one function of the float32 posed vertices (see
/// `posed_vertices`), whatever has been asked before and on whatever machine. The distance of two
/// triangles is 0 if and only if they touch as `collide` decides it, exactly. Otherwise it is
/// computed in double, is positive, and is off by less than 2^-46 times the largest difference of
/// two of their coordinates on an axis. Of triangles that are equally far, those with the lowest
/// numbers count.
///
/// A surface is not a solid: a body inside another that touches it nowhere is some way from it. A
/// rigid or static mesh is a model with one joint.
///
/// All trees of boxes are descended nearest first, and only what is nearer than the best pair so
/// far is opened. Branch and bound after Quinlan, "Efficient distance computation between
/// non-convex objects", 1994; boxes that wait until they are asked for are Kavan & Zara's (2005,
/// section 4.2).

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt {

/// A point of a posed surface.
struct SurfacePoint {
  std::uint32_t triangle = 0;              ///< its number in the model's triangle array
  std::array<float, 3> barycentrics = {};  ///< how much of each corner; sum to 1 up to rounding
  Vec3 position;                           ///< rounded to float
};

/// The answer of `closest_point`.
struct ClosestPoint {
  /// Infinite if nothing is within the maximum; the point then has no meaning.
  double distance = std::numeric_limits<double>::infinity();
  SurfacePoint point;

  /// Whether anything was found.
  explicit operator bool() const { return distance < std::numeric_limits<double>::infinity(); }
};

struct ClosestPointOptions {
  /// Nothing farther away is looked for. Not negative.
  double max_distance = std::numeric_limits<double>::infinity();
};

/// Writes the point of the posed surface that is closest to `point`. The distance is of the same
/// kind as that of two triangles; 0 only up to rounding.
///
/// Precondition: the coordinates of `point` are finite and at most 2^60. Cost grows with the parts
/// of the surface that are about as close as the closest.
PELT_API QueryStats closest_point(Pose& pose, const Vec3& point, Scratch& scratch,
                                  ClosestPoint& result, const ClosestPointOptions& options = {});

/// The same for each of `points`. Precondition: `results` has one element for each point. What one
/// point opens the others find open, so neighbours should follow each other.
PELT_API QueryStats closest_points(Pose& pose, std::span<const Vec3> points, Scratch& scratch,
                                   std::span<ClosestPoint> results,
                                   const ClosestPointOptions& options = {});

/// The answer of `distance`.
struct Distance {
  /// Of the two points. Infinite if nothing is within the maximum; the points then have no meaning.
  double distance = std::numeric_limits<double>::infinity();
  /// The least distance is proven to be no less: `distance` itself, if no tolerance was allowed;
  /// the maximum, if nothing is within it.
  double lower_bound = 0;
  SurfacePoint a, b;

  /// Whether anything was found.
  explicit operator bool() const { return distance < std::numeric_limits<double>::infinity(); }

  /// For `DistanceOptions::hint`.
  TreeLocation<4> location;
};

struct DistanceOptions {
  /// Nothing farther away is looked for. Not negative.
  double max_distance = std::numeric_limits<double>::infinity();
  /// The pair found may be so much farther than the closest one; which it is then depends on what
  /// has been asked before. The query ends earlier, with a `lower_bound` that is proven. Not
  /// negative.
  double tolerance = 0;
  /// An earlier answer for the same two models in nearly the same poses, or null: the search begins
  /// where that was found. No answer depends on it.
  const Distance* hint = nullptr;
};

/// The least distance of any triangle of `a` from any of `b`, and two points that have it.
///
/// Precondition: `a` and `b` are different poses (of the same model or of two); one pose given
/// twice aborts the program, in every build. Poses that touch cost what `collide` does, because the
/// lowest pair that touches is asked for; with a tolerance what `intersects` does.
PELT_API QueryStats distance(Pose& a, Pose& b, Scratch& scratch, Distance& result,
                             const DistanceOptions& options = {});

/// Two triangles that are no farther apart than a query asked, by their numbers in the two models'
/// triangle arrays. They need not intersect.
struct NearPair {
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const NearPair&, const NearPair&) = default;
};

struct ClearanceOptions {
  /// Stop after this many pairs. Which ones are found first is unspecified, and
  /// `QueryStats::cut_short` says whether any are missing.
  std::uint32_t max_pairs = std::numeric_limits<std::uint32_t>::max();
};

/// Appends every pair of triangles of `a` and `b` whose distance is at most `tolerance`, in
/// ascending order; with a tolerance of 0 these are the pairs of `collide`.
///
/// Preconditions: `a` and `b` are different poses, as for `distance`; the tolerance is not
/// negative. Cost grows with what comes so near.
PELT_API QueryStats clearance(Pose& a, Pose& b, double tolerance, Scratch& scratch,
                              std::vector<NearPair>& pairs, const ClearanceOptions& options = {});

/// Whether any triangles of `a` and `b` are at most `tolerance` apart; as `clearance`, stopping at
/// the first pair.
PELT_API YesNo is_within(Pose& a, Pose& b, double tolerance, Scratch& scratch);

}  // namespace pelt
