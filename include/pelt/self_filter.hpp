#pragma once

/// Filters of self-collision. A `SelfFilter` selects pairs of triangles to leave out of the answers
/// of pelt/self.hpp. `near_joints` finds the joints that are neighbours in the body of a character,
/// so that a filter can leave out the creases of its skin at joints. `ContactTally` finds pairs
/// that intersect in nearly all poses.

#include <pelt/config.hpp>

#include <pelt/collide.hpp>
#include <pelt/math.hpp>
#include <pelt/model.hpp>
#include <pelt/query.hpp>
#include <pelt/result.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct SelfFilter;
}

/// A pair of joints or of groups. Filters treat (a, b) and (b, a) as the same pair. The comparison
/// operators do not.
struct IndexPair {
  std::uint16_t first = 0, second = 0;

  friend auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

/// States that a zone contains a triangle. A zone is a set of triangles, named by any number that
/// the caller chooses. Zones may overlap.
struct TriangleZone {
  std::uint32_t triangle = 0;
  std::uint16_t zone = 0;
};

/// Selects intersecting pairs of triangles to leave out. By default, no pair is left out.
/// `build_self_filter` copies what it needs from the arrays. An empty array turns its filter off.
struct SelfFilterOptions {
  /// Leaves out neighbours. 0 leaves out none. 1 leaves out pairs that share a surface vertex (see
  /// `self_collide`). A greater value k also leaves out pairs that are connected by a chain of at
  /// most k - 1 other triangles, where each triangle shares a surface vertex with the next one. At
  /// most 64.
  std::uint32_t rings = 0;

  /// [T] A flag for each triangle. Leaves out pairs in which a triangle has the flag 0, for example
  /// because it is hidden.
  std::span<const std::uint8_t> takes_part = {};

  /// Leaves out these pairs, listed in any order. Meant for pairs that intersect in a reference
  /// pose, such as the rest pose. `self_collide` in that pose finds them.
  std::span<const Contact> at_rest = {};

  /// Leaves out these pairs, listed in any order. Meant for pairs that intersect in nearly all
  /// poses, such as layers of clothes. `ContactTally` finds them.
  std::span<const Contact> always = {};

  /// [J] A number for each joint. `joint_parents`, `joint_pairs` and `joint_pairs_in_zones` treat
  /// joints with equal numbers as one joint. The main joint of a triangle is still a single joint:
  /// the weights of joints with equal numbers are not added. Use this for joints that no clip moves
  /// relative to each other.
  std::span<const std::uint16_t> joint_bodies = {};

  /// [J] The parent of each joint, or `kNoJoint`. Leaves out pairs of triangles whose main joints
  /// are the same, or are parent and child. The main joint of a triangle is the joint with the
  /// largest sum of weights over its vertices.
  std::span<const std::uint16_t> joint_parents = {};

  /// Leaves out pairs of triangles whose two main joints are listed here as a pair.
  std::span<const IndexPair> joint_pairs = {};

  /// Leaves out pairs of triangles whose two main joints are listed here as a pair, but only if one
  /// of the `zones` contains both triangles. Meant for creases: the zone of an elbow leaves out
  /// contacts of forearm and upper arm near the elbow, but not near the wrist.
  std::span<const IndexPair> joint_pairs_in_zones = {};

  /// The triangles of all zones, listed in any order.
  std::span<const TriangleZone> zones = {};

  /// [T] The group of each triangle: any number that the caller chooses, such as the index of its
  /// material. Leaves out pairs of triangles whose two groups are listed in `group_pairs`.
  std::span<const std::uint16_t> groups = {};
  std::span<const IndexPair> group_pairs = {};
};

inline constexpr std::uint16_t kNoJoint = 0xFFFF;

/// The filters, in the order in which they are applied. A pair is counted only for the first filter
/// that leaves it out. `joints` stands for `joint_parents`, `joint_pairs` and
/// `joint_pairs_in_zones`.
enum class LeftOutBy : std::uint8_t { none, takes_part, rings, at_rest, always, joints, groups };

/// Number of intersecting pairs that each filter has left out.
struct LeftOut {
  std::uint64_t takes_part = 0, rings = 0, at_rest = 0, always = 0, joints = 0, groups = 0;

  std::uint64_t total() const { return takes_part + rings + at_rest + always + joints + groups; }
  PELT_API LeftOut& operator+=(const LeftOut& other);
};

/// The neighbours of a model's triangles, and filters. Create one `SelfFilter` for each model and
/// choice of filters. Immutable, cheap to copy (copies share the data), safe to use from any number
/// of threads.
class PELT_API SelfFilter {
 public:
  const SkinnedModel& model() const;

  /// Returns the first filter that leaves out the pair of triangles `s` and `t`, or `none`. Does
  /// not test whether the triangles intersect. For many pairs, see `leave_out`.
  ///
  /// Precondition: `s` and `t` are different triangles of the model.
  ///
  /// Cost: O(log P), where P is the number of pairs listed in the options. If `rings` is more than
  /// 1, also O(V + triangles in the rings), and allocates.
  LeftOutBy left_out_by(std::uint32_t s, std::uint32_t t) const;

  /// Working memory of `self_collide`, for `Scratch::reserve`.
  SelfScratchSize scratch_size() const;

  /// Bytes of the data that all copies share, without the model: 32 to 45 bytes per triangle of a
  /// character, and less than 1 KB per triangle of any mesh. Each listed pair adds 8 bytes,
  /// each element of `zones` at most 14.
  std::size_t memory_bytes() const;

  /// For internal use.
  explicit SelfFilter(std::shared_ptr<const detail::SelfFilter> filter);
  const detail::SelfFilter& detail() const { return *filter_; }

 private:
  std::shared_ptr<const detail::SelfFilter> filter_;
};

/// Finds the neighbours of a model's triangles and prepares the filters.
///
/// Cost: O(T log T). Allocates.
///
/// Returns an error if an array has the wrong size, `group_pairs` is given without `groups`, a
/// triangle or joint does not exist, `rings` is more than 64, or the model has more than 2^28
/// triangles. For a wrong element, the error names the array and the index.
PELT_API Result<SelfFilter> build_self_filter(const SkinnedModel& model,
                                              const SelfFilterOptions& options = {});

/// Removes from `contacts` the pairs that `filter` leaves out. Use this function for contacts
/// between parts of one character that another query has found, for example `collide` of a coat and
/// the body below it. Returns the number of pairs that each filter has removed. In each remaining
/// pair, the two indices are exchanged if necessary, so that triangle_a < triangle_b. The pairs are
/// not sorted again. Sort them before you pass them to `describe_contacts` or `ContactTally::add`.
///
/// Preconditions:
/// `filter`: made for the model of the whole character.
/// `contacts`: pairs of different triangles, numbered as in this model.
/// `scratch`: not used by another thread at the same time.
///
/// Cost: O(log P) per contact, where P is the number of pairs listed in the options of the filter.
/// If `rings` is more than 1, also O(V) once per call, and O(triangles in the rings) per contact.
///
/// Allocates only if it needs more memory in `scratch` than any earlier query.
PELT_API LeftOut leave_out(const SelfFilter& filter, Scratch& scratch,
                           std::vector<Contact>& contacts);

/// Counts, for each pair of triangles, the poses in which the pair intersects.
class PELT_API ContactTally {
 public:
  ContactTally();
  ContactTally(ContactTally&&) noexcept;
  ContactTally& operator=(ContactTally&&) noexcept;
  ~ContactTally();

  /// Adds the contacts of one pose.
  ///
  /// Precondition: `contacts` is in ascending order, without repetition.
  ///
  /// Cost: linear in the distinct pairs of all poses so far. Allocates.
  void add(std::span<const Contact> contacts);

  std::uint32_t pose_count() const;

  /// Returns, in ascending order, the pairs that intersect in at least this share (0 to 1) of the
  /// poses.
  std::vector<Contact> in_share_of_poses(double share) const;

 private:
  struct Tally;
  std::unique_ptr<Tally> tally_;
};

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

/// Values of members of `SelfFilterOptions`: `bodies` is for `joint_bodies`, the others are for the
/// members with the same names.
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
/// - if one is the next body above the other, not counting bodies that move no triangles, and their
///   triangles share no corner;
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
/// `at_rest`: contacts in reference poses, in any order. Find them with the filter that an empty
///   `at_rest` gives; contacts in creases would make their joints near everywhere.
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
