#pragma once

/// The surface of a model, which says how its triangles are connected; and the geometry of
/// contacts, for solvers, reports and pictures.
///
/// Call `describe_contacts` after `collide` or `self_collide`. For each contact, it computes a
/// trace: positions, a normal, a depth and joints. Most triangles that are in contact intersect in
/// a segment. `describe_contacts` chains these segments into curves, and joins connected contacts
/// into patches.

#include <pelt/config.hpp>

#include <pelt/collide.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct Surface;
}

/// How the triangles of a model are connected, and the main joint of each triangle: the joint with
/// the largest sum of weights over the triangle's vertices; of equal sums, the lowest joint.
/// `SkinnedModel::surface` returns it, and queries that need it find it themselves. Immutable,
/// cheap to copy (copies share the data and the model), safe to use from any number of threads.
class PELT_API Surface {
 public:
  /// Whether the surface is closed: each edge belongs to exactly two triangles, which traverse the
  /// edge in opposite directions. A closed surface separates inside from outside in every pose.
  /// Vertices that the model has merged (see `ModelOptions::weld`) count as one vertex, and
  /// triangles with a repeated vertex are ignored; a surface without others is not closed.
  bool is_closed() const;

  /// For internal use.
  explicit Surface(std::shared_ptr<const detail::Surface> surface);
  const detail::Surface& detail() const { return *surface_; }

 private:
  std::shared_ptr<const detail::Surface> surface_;
};

enum class ContactKind : std::uint8_t {
  segment,   ///< the triangles intersect in a segment
  point,     ///< the triangles touch in one point
  coplanar,  ///< the triangles overlap or touch in one plane
  collapsed  ///< a triangle has collapsed to a segment or a point
};

/// The intersection of the two triangles of a contact. Which features (vertices, edges or
/// interiors) intersect is decided exactly on the float32 posed vertices. Positions are rounded.
struct ContactTrace {
  Contact contact;
  ContactKind kind = ContactKind::segment;

  /// Ends of the segment, in the frame of the joint palette, in the direction n_a x n_b of the
  /// normals of the triangles. For kind `point`, both ends are that point, and for kinds `coplanar`
  /// and `collapsed` the midpoint between the centres of the triangles. Error: less than 2^-23
  /// times the largest absolute coordinate of the two triangles.
  Vec3 from, to;

  /// Direction in which `a` should move to leave `b`: the unit vector along n_b - n_a, for the unit
  /// normals n_a and n_b of the triangles, or n_b if both are equal. The normal of a collapsed
  /// triangle counts as zero; if both have collapsed, `normal` is zero. docs/queries.md ("Errors of
  /// contact geometry") bounds the error.
  Vec3 normal;

  /// Overlap of the two triangles along `normal`, 0 or more: moved by `depth` along `normal`, the
  /// triangle of `a` at most touches that of `b`. A finer mesh gives a smaller depth; for the depth
  /// of one body inside another, see `deepest_vertex`. Error: less than 2^-23 times the longest
  /// distance between two corners of the triangles.
  float depth = 0;

  std::uint16_t joint_a = 0, joint_b = 0;  ///< main joints of the triangles (see `Surface`)
};

/// One step along a curve.
struct CurveStep {
  std::uint32_t trace = 0;   ///< index into ContactGeometry::traces
  bool is_reversed = false;  ///< traversed from `to` to `from`
};

/// A chain of segments. Consecutive segments have a common end, bit for bit.
struct ContactCurve {
  std::uint32_t first = 0, count = 0;  ///< range in ContactGeometry::steps
  bool is_closed = false;              ///< the last segment ends where the first one starts

  /// Sum of the lengths of the segments. docs/queries.md ("Errors of contact geometry") bounds the
  /// errors of `length` and `area`.
  float length = 0;

  /// The area that a closed curve encloses: that of its projection along the direction in which
  /// this area is largest. Parts around which the curve runs in opposite directions, such as both
  /// halves of an 8, cancel each other. 0 if the curve is not closed.
  float area = 0;
};

/// A connected set of contacts. Two contacts are neighbours if they share one triangle and their
/// other triangles share a vertex.
///
/// `point` and `normal` are means over the traces of the patch. Each trace has the length of its
/// segment as weight. If all lengths are zero, all traces have equal weights.
///
/// In a patch of a pose with itself, each contact has one triangle on side a and the other on side
/// b. A triangle that two neighbouring contacts share is on the same side in both. The first trace
/// has triangle_a on side a. A trace with triangle_a on side b contributes its normal negated and
/// its joints exchanged. If a triangle would be on both sides, all traces contribute unchanged.
struct ContactPatch {
  std::uint32_t first = 0, count = 0;  ///< range in ContactGeometry::members

  /// Sum of the lengths of all segments: the length of the line in which the surfaces intersect.
  /// Does not depend on the size of the triangles. To sort patches by severity, sort by length.
  float length = 0;

  Vec3 point;   ///< mean of the midpoints of the segments
  Vec3 normal;  ///< unit vector along the mean of the traces' normals; zero if the mean is zero

  /// The largest depth of a trace. One large triangle with a small overlap may give a large depth.
  float depth = 0;

  /// The most frequent joint of each side; of equally frequent joints, the lowest.
  std::uint16_t joint_a = 0, joint_b = 0;
};

/// Result of `describe_contacts`. Reuse one object: a call then allocates in the object only if
/// there are more contacts, curves or patches than in any earlier call.
struct ContactGeometry {
  std::vector<ContactTrace> traces;    ///< one per contact, in the order of the contacts
  std::vector<CurveStep> steps;        ///< steps of all curves, curve by curve
  std::vector<ContactCurve> curves;    ///< each segment is in one curve
  std::vector<std::uint32_t> members;  ///< indices into `traces`, ascending within each patch
  std::vector<ContactPatch> patches;   ///< in descending order of their `count`
};

/// Computes the geometry of contacts that `collide(a, b, ...)` has found. Replaces the contents of
/// `geometry`, unlike other queries, which append to lists.
///
/// Two segments are chained if both have an end where the same two features intersect. Coordinates
/// are not compared, so rounding does not break curves. Two closed surfaces in general position
/// intersect in closed curves. A curve ends at the border of a surface that is not closed. A curve
/// also ends where more than two segments meet. This happens if an edge lies in a triangle, if a
/// vertex lies on an edge, or if parts of the surfaces coincide.
///
/// Preconditions:
/// `a`, `b`: the poses that were passed to `collide`, with unchanged palettes and morph weights.
///   Passing one pose twice aborts the program, in every build.
/// `contacts`: ascending, without repetition, with triangle indices in range.
///
/// Cost: O(C log C) for C contacts. Opens the nodes that contain the contacts, unless they are
/// still open from `collide`.
///
/// Allocates in the poses, for nodes that are opened, and the surfaces of the models, if
/// `SkinnedModel::surface` has not made them yet. Also allocates in `scratch` and `geometry` if
/// there are more contacts, curves or patches than in any earlier call; `Scratch::reserve` does not
/// prevent this.
///
/// If memory runs out, the contents of `geometry` are unspecified.
PELT_API QueryStats describe_contacts(Pose& a, Pose& b, std::span<const Contact> contacts,
                                      Scratch& scratch, ContactGeometry& geometry);

/// Like the function above, for contacts of a pose with itself, which `self_collide` has found. A
/// trace describes the whole intersection of two closed triangles, including corners that the
/// triangles share:
/// - If the triangles share no corner, the trace is the same as for triangles of two poses.
/// - If the triangles share one corner, are not in one plane, and have not collapsed, the triangles
///   intersect in a segment with one end at that corner.
/// - In all other cases, the kind is `coplanar` or `collapsed`, and there is no segment.
///
/// triangle_a is always the triangle with the lower number, so it may be on either side of a curve.
/// Where it changes sides along the curve, `CurveStep::is_reversed` changes, too.
///
/// Curves do not continue through a corner that the two triangles of a segment share. In general
/// position, each curve of a closed surface is closed, or starts and ends at such corners, for
/// example at the ends of a crease. If a filter of `self_collide` has left out contacts, curves end
/// where these contacts are missing.
///
/// Unlike `self_collide`, this function does not treat vertices with different influences as one
/// vertex, even if their positions are equal. A curve ends at a seam between such vertices.
///
/// Preconditions:
/// `pose`: the pose that was passed to `self_collide`, with unchanged palette and morph weights.
/// `contacts`: ascending, without repetition, with triangle indices in range and triangle_a <
///   triangle_b.
///
/// Cost and allocation: those of the function above.
PELT_API QueryStats describe_contacts(Pose& pose, std::span<const Contact> contacts,
                                      Scratch& scratch, ContactGeometry& geometry);

}  // namespace pelt
