#pragma once

/// Geometry of contacts: where two skins intersect, as segments chained into curves and gathered
/// into patches, with positions, normals and joints for solvers, reports and pictures. Call
/// `describe_contacts` after `collide`.

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

/// Stores which triangles of a model are adjacent, and for each triangle the joint with the largest
/// sum of weights over its vertices. Create one surface per model. Immutable, cheap to copy (copies
/// share), safe to use from any number of threads.
class PELT_API Surface {
 public:
  /// O(T log T). Allocates 22 bytes per triangle.
  explicit Surface(const SkinnedModel& model);

  /// Whether each edge has exactly two triangles that traverse it in opposite directions, so that
  /// the posed surface separates inside from outside. Bit-identical vertices count as one.
  /// Triangles with a repeated vertex are ignored; without other triangles, the surface is not
  /// closed.
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
  coplanar,  ///< the triangles overlap or touch in one plane; there are no ends
  collapsed  ///< a triangle has collapsed to a segment or a point; there are no ends
};

/// The intersection of two triangles. Which features (vertices, edges or interiors) of the
/// triangles meet is decided exactly on the float32 posed vertices. Positions are rounded.
struct ContactTrace {
  Contact contact;
  ContactKind kind = ContactKind::segment;

  /// Ends of the segment, in the direction n_a x n_b of the triangles' normals; for kind `point`,
  /// both are that point. Each coordinate is off by less than 2^-23 times the largest coordinate of
  /// the two triangles. For kinds `coplanar` and `collapsed`, both are the midpoint between the
  /// centres of the two triangles.
  Vec3 from, to;

  /// Unit vector, the direction in which `a` should move to leave `b`: the bisector of n_b and
  /// -n_a, for the unit normals n_a and n_b of the triangles. If n_a equals n_b, it is n_b. A
  /// collapsed triangle has the normal zero here, so `normal` is zero only if both triangles have
  /// collapsed.
  Vec3 normal;

  /// How far the triangle of `a` reaches behind the triangle of `b` along `normal`. If the triangle
  /// of `a` moved by `depth` along `normal`, the triangles would at most touch. Never larger than
  /// the triangles, so a finer mesh makes it smaller. It does not measure the depth of one body
  /// inside another; see `deepest_vertex`.
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
struct ContactPatch {
  std::uint32_t first = 0, count = 0;  ///< range in ContactGeometry::members
  float length = 0;                    ///< sum of the lengths of all segments
  Vec3 point;                          ///< mean of the traces' midpoints, weighted by length
  Vec3 normal;      ///< mean of the traces' normals, likewise; unit length, or zero if they cancel
  float depth = 0;  ///< the largest depth of the traces
  std::uint16_t joint_a = 0, joint_b = 0;  ///< the most frequent joints of the traces
};

/// Result of `describe_contacts`. Reuse the object: writing to it again allocates only for more
/// contacts than before.
struct ContactGeometry {
  std::vector<ContactTrace> traces;    ///< one per contact, in the order of the contacts
  std::vector<CurveStep> steps;        ///< steps of all curves, curve by curve
  std::vector<ContactCurve> curves;    ///< all segments, each in one curve
  std::vector<std::uint32_t> members;  ///< indices into `traces`, ascending within each patch
  std::vector<ContactPatch> patches;   ///< the one with the most contacts first
};

/// Replaces the content of `geometry` with the geometry of contacts that `collide(a, b, ...)` has
/// found.
///
/// Curves are chained by the features that intersect and not by coordinates, so they are complete:
/// two closed surfaces in general position intersect in closed curves. Curves end at the border of
/// a surface that is not closed, and where more than two segments meet. The latter happens if edges
/// lie in faces, vertices lie on edges, or the surfaces have parts in common.
///
/// Preconditions:
/// `a`, `b`: with the palettes and morph weights of the call of `collide`.
/// `surface_a`, `surface_b`: surfaces of the models of `a` and `b`. The surface of another model
///   aborts the program, in every build.
/// `contacts`: ascending, without repetition, and in range.
///
/// Cost: O(C log C) for C contacts. Opens the nodes that contain the contacts, unless they are
/// still open from `collide`.
PELT_API QueryStats describe_contacts(Pose& a, const Surface& surface_a, Pose& b,
                                      const Surface& surface_b, std::span<const Contact> contacts,
                                      Scratch& scratch, ContactGeometry& geometry);

}  // namespace pelt
