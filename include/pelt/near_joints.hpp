#pragma once

/// Which joints of a character are neighbours in its body, so that a `SelfFilter` can leave out the
/// creases of its skin at joints.

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/export.hpp>
#include <pelt/math.hpp>
#include <pelt/model.hpp>
#include <pelt/result.hpp>
#include <pelt/self_collide.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt {

/// The rigid bodies of a character. Joints that never move relative to each other are one body,
/// such as a bone and the armour that is attached to it. A body is named by its lowest joint.
struct JointBodies {
  std::vector<std::uint16_t> of_joints;  ///< [J] the body of each joint

  /// [J] For each joint, the next body above its body in the hierarchy, or `kNoJoint`. Bodies that
  /// move no triangles count, too.
  std::vector<std::uint16_t> above;
};

/// Returns the bodies of joints that all move: each joint is a body.
///
/// `joint_parents`: [J] the parent of each joint, or `kNoJoint`.
PELT_API JointBodies bodies_of_parents(std::span<const std::uint16_t> joint_parents);

/// For the members of `SelfFilterOptions` with these names; `bodies` for `joint_bodies`.
struct NearJoints {
  std::vector<std::uint16_t> bodies;  ///< [J] the lowest joint of each joint's body
  std::vector<IndexPair> joint_pairs, joint_pairs_in_zones;  ///< of bodies
  std::vector<TriangleZone> zones;                           ///< named by bodies
};

/// Returns which joints are neighbours in the body of a character, whatever its rig looks like. The
/// triangles of a body are those whose main joint (see `Surface`) is a joint of the body. A body is
/// near itself. Two bodies are near
/// - if one is anywhere above the other in the hierarchy, and triangles of both share a corner, as
///   at an armpit: only in the zone of the joint, where the skin creases;
/// - if one is the next above the other, without bodies that move no triangles, and no triangles of
///   both share a corner;
/// - if triangles of both touch in `at_rest`, as in a ball joint, or at a foot that is no child of
///   its leg.
///
/// The zone of a body is a ball around its border: the corners that its triangles share with those
/// of bodies above it. The centre of the ball is the centre of the border's bounding box. Its
/// radius is 2.5 times the distance of the farthest corner of the border from the centre, or 2.5
/// times the thickness of the body, if that is larger. The thickness is the root mean square
/// distance of the corners of the body's triangles from the line through the centre and the mean of
/// these corners. The zone contains the triangles of the body and of those that adjoin it above, if
/// they have a corner in the ball.
///
/// Limits, which only hostile models reach: corners that more than 64 bodies share at one position
/// are ignored. At a corner, only the nearest 64 bodies above that move triangles are considered.
/// Zones are built in the order of bodies. Once building them would test more than 64 T triangles
/// in total, the remaining bodies have no zones; they are near everywhere to those that they share
/// corners with.
///
/// `bodies`: of the joints of the model. For characters of glTF files, see `asset::joint_bodies`.
/// `positions`: [V] posed vertices in a pose in which each part of the body is in its place; any
///   such pose gives nearly the same zones. Empty: the rest positions.
/// `at_rest`: contacts in reference poses, in any order, found with the filter that an empty
///   `at_rest` gives. Otherwise, joints whose skin creases at rest are near everywhere.
///
/// Cost: O(T log T + V). Allocates.
///
/// Returns an error if an array has the wrong size, a joint or triangle does not exist, a body is
/// not named by its lowest joint, joints of one body have different bodies above, a body is above
/// itself, or a position is not finite.
PELT_API Result<NearJoints> near_joints(const SkinnedModel& model, const JointBodies& bodies,
                                        std::span<const Vec3> positions,
                                        std::span<const Contact> at_rest);

}  // namespace pelt
