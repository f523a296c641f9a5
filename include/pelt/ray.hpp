#pragma once

/// Rays against the posed skin. Hits are decided exactly on the float32 posed vertices (see
/// `posed_vertices`), so no ray slips between triangles that share an edge or a vertex.
///
/// A triangle is a closed set: a ray through an edge hits all triangles at the edge, and a ray
/// through a vertex hits all triangles around the vertex. A ray does not hit a triangle to which it
/// is parallel, even if it lies in the triangle's plane. No ray hits a triangle that has collapsed
/// to a segment or a point. A ray with infinite t_max that starts inside a closed mesh always hits
/// the mesh, because it leaves through triangles that are not parallel to it.
///
/// Answers have the same bits on every machine and do not depend on earlier queries.

#include <pelt/config.hpp>

#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt {

/// The points origin + t * direction with t_min <= t <= t_max, in the frame of the joint palette.
/// The direction may have any length. t is in units of this length. A ray with direction zero hits
/// no triangle.
///
/// Preconditions of queries: all coordinates are finite, and neither t_min nor t_max is NaN. Both
/// may be infinite. Otherwise the program aborts, in every build.
struct Ray {
  Vec3 origin, direction;
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
};

/// Returns the ray from `from` (t = 0) to `to` (t = 1). Each coordinate of the direction is rounded
/// to float, so the point at t = 1 differs from `to` by at most this rounding.
PELT_API Ray segment(const Vec3& from, const Vec3& to);

/// Which triangles a ray can hit, by the side from which the ray arrives. The front of a triangle
/// is the side from which its posed vertices appear counter-clockwise. A mirroring palette
/// therefore exchanges front and back.
enum class Facing : std::uint8_t {
  both,   ///< all triangles
  front,  ///< only triangles hit from their front
  back,   ///< only triangles hit from their back
};

inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFF;

struct RayHit {
  std::uint32_t triangle = kNoTriangle;  ///< index into the model's triangle array
  TreeLocation<1> location;              ///< for `influences_at`

  /// Parameter of the hit: the exact t, rounded to the nearest float32. The rounded t is compared
  /// with t_min and t_max.
  float t = std::numeric_limits<float>::infinity();

  /// Weights of the triangle's three vertices. The hit point is the sum of weight x vertex. No
  /// weight is negative, and each is accurate to 2^-23. If the ray hits an edge, the weight of the
  /// opposite vertex is 0.
  std::array<float, 3> barycentrics = {};

  /// Unit normal of the triangle. It points to the front.
  Vec3 normal;

  /// Whether anything was hit.
  explicit operator bool() const { return triangle != kNoTriangle; }

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// Writes the first hit of each ray: the hit with the least rounded `t`. If several triangles are
/// hit at this `t`, for example at a shared edge, the triangle with the lowest index is written.
/// For a ray that hits nothing, a default-constructed `RayHit` is written.
///
/// Precondition: `hits` has one element per ray. Otherwise the program aborts, in every build.
///
/// Cost: a ray opens a node only if it enters the node's box before the first hit found so far. One
/// ray at a character of 26,756 triangles takes 3 us including a new palette, and hardly more with
/// four times as many triangles. Nodes that one ray opens stay open for the other rays. Opening all
/// nodes at once costs less per node than opening single nodes. `cast` therefore opens all
/// remaining nodes when its rays have opened an eighth of the mesh and at least half of its rays
/// remain to be cast.
///
/// Allocates only in the pose, for nodes that are opened.
PELT_API QueryStats cast(Pose& pose, std::span<const Ray> rays, std::span<RayHit> hits,
                         Facing facing = Facing::both);

/// Like `cast` of several rays, for one ray.
PELT_API QueryStats cast(Pose& pose, const Ray& ray, RayHit& result, Facing facing = Facing::both);

/// Writes whether each ray hits anything. Like `cast`, but stops at any hit.
///
/// Precondition: `hit` has one element per ray. Otherwise the program aborts, in every build.
PELT_API QueryStats cast_any(Pose& pose, std::span<const Ray> rays, std::span<bool> hit,
                             Facing facing = Facing::both);

/// Appends all hits of a ray, ordered by t, and hits with equal t by the index of the triangle. A
/// ray through a shared edge hits all triangles at the edge.
///
/// Cost: opens all nodes whose boxes the ray enters.
///
/// Allocates only if it needs more memory in the pose, in `scratch` or in `hits` than any earlier
/// query.
PELT_API QueryStats cast_all(Pose& pose, const Ray& ray, Scratch& scratch,
                             std::vector<RayHit>& hits, Facing facing = Facing::both);

/// A joint, and the share with which it moves a point.
struct JointShare {
  std::uint32_t joint = 0;
  float share = 0;

  friend bool operator==(const JointShare&, const JointShare&) = default;
};

/// Appends the joints that move a hit point, each with its share in moving the point. The shares
/// are the influence weights of the triangle's vertices, blended with the barycentrics of the hit.
/// Shares are positive and sum to 1 up to rounding. The joints are in descending order of share,
/// and joints with equal shares in ascending order of index. The returned work is zero, because no
/// vertex is posed.
///
/// Precondition: `hit` is a hit on a pose of `model`. A hit that cannot be on this model aborts the
/// program, in every build.
///
/// Cost: a search for one node of the tree. Allocates only in `shares`.
PELT_API QueryStats influences_at(const SkinnedModel& model, const RayHit& hit,
                                  std::vector<JointShare>& shares);

}  // namespace pelt
