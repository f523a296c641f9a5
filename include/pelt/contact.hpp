#pragma once

/// Geometry of contacts, for solvers, reports and pictures. Call `describe_contacts` after
/// `collide` or `self_collide`. For each contact, it computes positions, a normal, a depth and
/// joints. It also chains the segments in which triangles intersect into curves, and gathers
/// connected contacts into patches.

#include <pelt/cxx20.hpp>

#include <pelt/collide.hpp>
#include <pelt/export.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt {

namespace detail {
struct Surface;
}

/// Adjacency of the triangles of a model, and for each triangle the joint with the largest sum of
/// weights over its vertices. Create one surface per model. Immutable, cheap to copy (copies
/// share), safe to use from any number of threads.
class PELT_API Surface {
 public:
  /// Cost: O(T log T). Allocates. The surface takes about 14 bytes per triangle.
  explicit Surface(const SkinnedModel& model);

  /// Whether each edge has exactly two triangles that traverse it in opposite directions, so that
  /// the posed surface separates inside from outside. Bit-identical vertices count as one: those
  /// with the same bits in rest position, influences and displacements. Triangles with a repeated
  /// vertex are ignored. If all triangles have a repeated vertex, the surface is not closed.
  bool is_closed() const;

  const SkinnedModel& model() const;

  /// For internal use.
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

/// The intersection of two triangles. The features (vertices, edges or interiors) that meet are
/// determined exactly from the float32 posed vertices. Positions are rounded.
struct ContactTrace {
  Contact contact;
  ContactKind kind = ContactKind::segment;

  /// Ends of the segment. The direction from `from` to `to` is n_a x n_b, for the normals n_a and
  /// n_b of the triangles. For kind `point`, `from` and `to` are both that point. Each coordinate
  /// is off by less than 2^-23 times the largest coordinate of the two triangles. For kinds
  /// `coplanar` and `collapsed`, `from` and `to` are both the midpoint between the centres of the
  /// triangles.
  Vec3 from, to;

  /// Direction in which `a` should move to leave `b`: the unit vector along n_b - n_a, for the unit
  /// normals n_a and n_b of the triangles, or n_b if both normals are equal. If one triangle has
  /// collapsed, its normal counts as zero. If both have collapsed, `normal` is zero.
  Vec3 normal;

  /// How far the triangle of `a` reaches behind the triangle of `b` along `normal`. If the triangle
  /// of `a` moved by `depth` along `normal`, the triangles would at most touch. The depth depends
  /// on the size of the triangles: a finer mesh makes it smaller. For the depth of one body inside
  /// another, see `deepest_vertex`.
  float depth = 0;

  /// For each of the two triangles, the joint with the largest sum of weights over the triangle's
  /// vertices. Of joints with equal sums, the lowest.
  std::uint16_t joint_a = 0, joint_b = 0;
};

/// One step along a curve.
struct CurveStep {
  std::uint32_t trace = 0;   ///< index into ContactGeometry::traces
  bool is_reversed = false;  ///< traversed from `to` to `from`
};

/// Consecutive segments. Neighbouring segments share an end, bit for bit.
struct ContactCurve {
  std::uint32_t first = 0, count = 0;  ///< range in ContactGeometry::steps
  bool is_closed = false;              ///< the last segment ends where the first one starts
};

/// A connected set of contacts. Two contacts are neighbours if they share one triangle and their
/// other triangles share a vertex.
///
/// `point` and `normal` are computed from means over the patch's traces. In these means, each trace
/// is weighted by the length of its segment, or all traces equally if all lengths are zero.
///
/// Contacts of a pose with itself: triangle_a is the triangle with the lower number, so the two
/// sides of a patch can be numbered in any order. `normal`, `joint_a` and `joint_b` follow the
/// sides of the patch: side a is that of triangle_a of the patch's first trace. Where a trace has
/// its triangles on the other sides, its normal counts with the opposite sign, and its joints are
/// exchanged. If a patch is so folded that its sides change into each other, each trace counts as
/// it is.
struct ContactPatch {
  std::uint32_t first = 0, count = 0;  ///< range in ContactGeometry::members
  float length = 0;                    ///< sum of the lengths of all segments
  Vec3 point;                          ///< mean of the traces' midpoints
  Vec3 normal;      ///< unit vector along the mean of the traces' normals; zero if they cancel
  float depth = 0;  ///< the largest depth of the traces
  std::uint16_t joint_a = 0, joint_b = 0;  ///< the most frequent joints of the traces
};

/// Result of `describe_contacts`. Reuse one object for many calls, which then allocate only if
/// there are more contacts, curves or patches than before.
struct ContactGeometry {
  std::vector<ContactTrace> traces;    ///< one per contact, in the order of the contacts
  std::vector<CurveStep> steps;        ///< steps of all curves, curve by curve
  std::vector<ContactCurve> curves;    ///< all segments, each in one curve
  std::vector<std::uint32_t> members;  ///< indices into `traces`, ascending within each patch
  std::vector<ContactPatch> patches;   ///< in descending order of their `count`
};

/// Computes the geometry of contacts that `collide(a, b, ...)` has found. Replaces the contents of
/// `geometry`, unlike other queries, which append to lists.
///
/// Segments are chained by the features that intersect and not by coordinates, so no curve is
/// broken by rounding: two closed surfaces in general position intersect in closed curves. A curve
/// ends at the border of a surface that is not closed. A curve also ends where more than two
/// segments meet, which happens if an edge lies in a triangle, if a vertex lies on an edge, or if
/// the surfaces have parts in common.
///
/// Preconditions:
/// `a`, `b`: the poses of that call of `collide`, with unchanged palettes and morph weights. The
///   same pose twice aborts the program, in every build.
/// `surface_a`, `surface_b`: surfaces of the models of `a` and `b`. The surface of another model
///   aborts the program, in every build.
/// `contacts`: ascending, without repetition, and in range.
///
/// Cost: O(C log C) for C contacts. Opens the nodes that contain the contacts, unless they are
/// still open from `collide`.
///
/// Allocates in the poses, for nodes that are opened. If there are more contacts, curves or patches
/// than in any earlier call with the same `scratch` and `geometry`, also allocates in these two
/// objects, even if `scratch` is reserved. If memory runs out, the contents of `geometry` are
/// unspecified.
PELT_API QueryStats describe_contacts(Pose& a, const Surface& surface_a, Pose& b,
                                      const Surface& surface_b, std::span<const Contact> contacts,
                                      Scratch& scratch, ContactGeometry& geometry);

/// Computes the geometry of contacts of a pose with itself, which `self_collide` has found, like
/// the function above. A trace describes the whole intersection of its two closed triangles,
/// including the corners that they share:
/// - If the triangles share no corner, the trace is that of any two triangles.
/// - If they share one corner and are not in one plane, they intersect in a segment that starts at
///   that corner.
/// - If they share an edge or all corners, or are in one plane, or a triangle has collapsed, the
///   kind is `coplanar` or `collapsed`, without a segment.
///
/// A curve may pass from triangles s and t to triangles t and u: steps are then reversed where the
/// triangle numbers change their order. In general position, the curves of a closed surface are
/// closed, or start and end at corners that two intersecting triangles share, as creases do.
///
/// If contacts are missing because a filter left them out, curves end there.
///
/// Preconditions:
/// `pose`: the pose of that call of `self_collide`, with unchanged palette and morph weights.
/// `surface`: the surface of the model of `pose`. The surface of another model aborts the program,
///   in every build. Unlike in `self_collide`, vertices with different influences are not one
///   vertex: a curve ends at a seam between them.
/// `contacts`: ascending, without repetition, in range, and triangle_a < triangle_b.
///
/// Cost, allocation: as above.
PELT_API QueryStats describe_contacts(Pose& pose, const Surface& surface,
                                      std::span<const Contact> contacts, Scratch& scratch,
                                      ContactGeometry& geometry);

}  // namespace pelt
