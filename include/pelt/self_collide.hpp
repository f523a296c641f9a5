#pragma once

/// Self-collision: which triangles of one pose intersect each other. Neighbouring triangles always
/// touch in the corners that they share; this does not count as intersection. A `SelfFilter`
/// selects pairs of triangles to leave out of the answer.

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/export.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>
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

/// Work of `self_collide`, and the number of pairs that its filters have left out.
struct SelfStats : QueryStats {
  LeftOut left_out;
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
/// Equal corners of a triangle count as one. In a triangle with the corners p, p and q, the edge
/// opposite p is therefore the point q. Two triangles are duplicates if both have no corner that
/// the other does not share.
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
                                std::vector<Contact>& contacts, const CollideOptions& options = {});

/// Returns whether any triangles of `pose` intersect each other. Like `self_collide`, but stops at
/// the first contact that the filter does not leave out.
PELT_API YesNo self_intersects(Pose& pose, const SelfFilter& filter, Scratch& scratch);

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

}  // namespace pelt
