#pragma once

/// Rays against the posed skin. Hits are decided exactly on the float32 posed vertices (see
/// `posed_vertices`), so no ray passes through an edge or a vertex that triangles share.
///
/// A triangle is a closed set: a ray through an edge hits both triangles, and a ray through a
/// vertex hits all triangles around it. A ray in the plane of a triangle, or parallel to it, does
/// not hit the triangle, and no ray hits a triangle that has collapsed to a segment or a point. A
/// ray from inside a closed mesh always hits something, because it leaves through triangles that
/// are not parallel to it.
///
/// Answers have the same bits on every machine and do not depend on earlier queries.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt {

/// The points origin + t * direction with t_min <= t <= t_max, in the frame of the joint palette. t
/// is in units of the direction's length, which need not be 1. A ray with direction zero hits no
/// triangle.
///
/// Precondition of queries: coordinates are finite; t_min and t_max may be infinite, but are not
/// NaN. Otherwise the program aborts, in every build.
struct Ray {
  Vec3 origin, direction;
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
};

/// Returns the ray from `from` (t = 0) to `to` (t = 1). Each coordinate of the direction is rounded
/// to float, so at t = 1 the ray misses `to` by at most the rounding of the direction.
PELT_API Ray segment(const Vec3& from, const Vec3& to);

/// Selects the triangles that a ray can hit, according to the side of the triangle from which the
/// ray arrives. The posed vertices of a triangle appear counter-clockwise from its front, so a
/// mirroring palette exchanges front and back.
enum class Facing : std::uint8_t {
  both,   ///< all triangles
  front,  ///< only triangles hit from their front
  back,   ///< only triangles hit from their back
};

struct CastOptions {
  Facing facing = Facing::both;
};

inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFF;

struct RayHit {
  std::uint32_t triangle = kNoTriangle;  ///< index into the model's triangle array
  TreeLocation<1> location;              ///< for `influences_at`

  /// The float32 nearest to the exact parameter. This rounded value is compared with t_min and
  /// t_max.
  float t = std::numeric_limits<float>::infinity();

  /// Weights of the triangle's three vertices. The hit point is the sum of weight x vertex. Weights
  /// are not negative, and accurate to 2^-23. If the ray hits an edge, the weight of the opposite
  /// vertex is 0.
  std::array<float, 3> barycentrics = {};

  /// Unit normal of the triangle, on the side of its front.
  Vec3 normal;

  /// Whether anything was hit.
  explicit operator bool() const { return triangle != kNoTriangle; }

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// Writes the first hit of each ray, which is the hit with the least t. Of several triangles with
/// the same t, for example at a shared edge, the one with the lowest index is written.
///
/// Precondition: `hits` has one element per ray. Otherwise the program aborts, in every build.
///
/// Cost: opens only nodes whose boxes a ray enters before its first hit so far. A pick on a
/// character of 26,756 triangles takes 3 us including a new palette, and hardly more with four
/// times as many triangles. Nodes that one ray opens stay open for the others. Opening all nodes at
/// once costs less per node than opening single nodes. `cast` therefore opens all remaining nodes
/// when its rays have opened an eighth of the mesh and at least half of its rays remain.
///
/// Allocates only in the pose, for nodes that are opened.
PELT_API QueryStats cast(Pose& pose, std::span<const Ray> rays, std::span<RayHit> hits,
                         const CastOptions& options = {});

/// Like `cast` of several rays, for one ray.
PELT_API QueryStats cast(Pose& pose, const Ray& ray, RayHit& result,
                         const CastOptions& options = {});

/// Writes whether each ray hits anything. Like `cast`, but stops at any hit.
///
/// Precondition: `hit` has one element per ray. Otherwise the program aborts, in every build.
PELT_API QueryStats cast_any(Pose& pose, std::span<const Ray> rays, std::span<bool> hit,
                             const CastOptions& options = {});

/// Appends all hits of a ray, ordered by t and then by triangle. A ray through a shared edge hits
/// both of the edge's triangles.
///
/// Cost: opens all nodes whose boxes the ray enters. Allocates only if it needs more memory in the
/// pose, in `scratch` or in `hits` than any earlier query.
PELT_API QueryStats cast_all(Pose& pose, const Ray& ray, Scratch& scratch,
                             std::vector<RayHit>& hits, const CastOptions& options = {});

/// A joint, and the share with which it moves a point.
struct JointShare {
  std::uint32_t joint = 0;
  float share = 0;

  friend bool operator==(const JointShare&, const JointShare&) = default;
};

/// Appends the joints that move a hit point, with their shares: the influences of the triangle's
/// vertices, blended with the barycentrics of the hit. The largest share comes first; of equal
/// shares, the lowest joint. Shares are positive and sum to 1 up to rounding. The returned work is
/// zero, because nothing is posed.
///
/// Precondition: `hit` is a hit on a pose of this model. A hit that cannot be on this model aborts
/// the program, in every build.
///
/// Cost: a search for one node of the tree. Allocates only in `shares`.
PELT_API QueryStats influences_at(const SkinnedModel& model, const RayHit& hit,
                                  std::vector<JointShare>& shares);

}  // namespace pelt
