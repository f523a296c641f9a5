#pragma once

/// Rays against the posed skin. What a ray meets is decided exactly on the float32 posed vertices
/// (see `posed_vertices`), so that no ray slips through an edge or a corner that triangles share.
///
/// A triangle is a closed set: a ray through an edge hits both triangles, one through a corner all
/// around it. A ray that runs in a triangle's plane, or parallel to it, does not hit it, nor does
/// any ray a triangle that has collapsed to a segment or a point; from inside a closed mesh a ray
/// hits something all the same, because it leaves through triangles that it does not run along.
///
/// Answers are the same to the bit on every machine, and do not depend on what has been asked
/// before.

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
/// is in units of the direction's length, which may be any. No coordinate is NaN or infinite; the
/// ends may be infinite. A ray whose direction is zero hits nothing.
struct Ray {
  Vec3 origin, direction;
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
};

/// The ray from `from` (t = 0) to `to` (t = 1). Its direction is their difference, each coordinate
/// rounded to float: so it passes `to` by at most half a unit in the last place of that.
PELT_API Ray segment(const Vec3& from, const Vec3& to);

/// The side of a triangle from which a ray comes. Its front is where its corners are seen
/// counter-clockwise, as posed: a palette that mirrors turns triangles round.
enum class Facing : std::uint8_t {
  both,   ///< all triangles count
  front,  ///< only those that the ray meets from their front
  back,   ///< only those that it meets from their back
};

struct CastOptions {
  Facing facing = Facing::both;
};

inline constexpr std::uint32_t kNoTriangle = 0xFFFFFFFF;

struct RayHit {
  std::uint32_t triangle = kNoTriangle;  ///< its number in the model's triangle array
  TreeLocation<1> location;              ///< for `influences_at`

  /// The float32 nearest to the exact parameter; it is this that lies in t_min to t_max.
  float t = std::numeric_limits<float>::infinity();

  /// Of the triangle's corners, in their order: the hit is their weighted sum. None is negative,
  /// each is right to 2^-23, and 0 where the ray meets the edge opposite to its corner.
  std::array<float, 3> weights = {};

  /// Of the triangle, of length 1, to its front.
  Vec3 normal;

  /// Whether anything was hit.
  explicit operator bool() const { return triangle != kNoTriangle; }

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// Writes what each ray hits first: the triangle with the least t, the lowest of those where
/// several have the same, as where they share the edge that the ray goes through. Precondition:
/// `hits` has one element for each ray.
///
/// Opens only nodes whose boxes a ray enters before it has hit anything nearer: a pick at a
/// character of 26,756 triangles takes 3 us with its new palette, hardly more at four times as
/// many. What one ray has opened serves the next; once the rays of a call have opened an eighth of
/// the mesh and as many are left, all is opened, which then is cheaper. Allocates nothing but what
/// the pose needs to open nodes.
PELT_API QueryStats cast(Pose& pose, std::span<const Ray> rays, std::span<RayHit> hits,
                         const CastOptions& options = {});

/// The same for one ray.
PELT_API QueryStats cast(Pose& pose, const Ray& ray, RayHit& result,
                         const CastOptions& options = {});

/// Writes whether each ray hits anything; as `cast`, stopping at any hit. Precondition: `hit` has
/// one element for each ray.
PELT_API QueryStats cast_any(Pose& pose, std::span<const Ray> rays, std::span<bool> hit,
                             const CastOptions& options = {});

/// Appends everything that a ray hits, ascending by t and then by triangle. Each triangle that it
/// goes through is named, so an edge that two share is met twice.
PELT_API QueryStats cast_all(Pose& pose, const Ray& ray, Scratch& scratch,
                             std::vector<RayHit>& hits, const CastOptions& options = {});

/// How far a point follows a joint.
struct JointShare {
  std::uint32_t joint = 0;
  float share = 0;

  friend bool operator==(const JointShare&, const JointShare&) = default;
};

/// Appends the joints that move the place of a hit, those of the triangle's corners blended by the
/// hit's weights: the largest share first, of equal ones the lower joint. Shares are positive and
/// sum to 1 up to rounding. Precondition: `hit` is a hit on a pose of
/// this model.
PELT_API void influences_at(const SkinnedModel& model, const RayHit& hit,
                            std::vector<JointShare>& shares);

}  // namespace pelt
