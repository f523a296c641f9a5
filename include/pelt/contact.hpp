#pragma once

/// The geometry of contacts: where two skins cut each other, chained to curves and gathered to
/// regions, with the places, normals and joints that a solver, a report or a picture wants. Asked
/// for after `collide`, of the contacts that it found.

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

/// Which triangles of a model are neighbours, and what joints they follow: what contact geometry
/// needs beside the model. Made once for each model, immutable, cheap to copy (copies share), safe
/// to use from any number of threads.
class PELT_API Surface {
 public:
  /// O(T log T); allocates 22 bytes a triangle.
  explicit Surface(const SkinnedModel& model);

  /// Whether each edge has two triangles that run along it in opposite directions, so that the
  /// posed surface parts inside from outside. Vertices that are alike in every bit count as one.
  bool is_closed() const;

  const SkinnedModel& model() const;

  /// For Pelt's own files.
  const detail::Surface& detail() const { return *surface_; }

 private:
  std::shared_ptr<const detail::Surface> surface_;
};

enum class ContactKind : std::uint8_t {
  segment,   ///< the triangles cut each other in a segment
  point,     ///< they touch in one point
  coplanar,  ///< they overlap, or touch, in one plane; there are no ends
  collapsed  ///< one of them has collapsed to a segment or a point; there are no ends
};

/// What two triangles have in common. Which features meet is decided exactly on the float32 posed
/// vertices; places are rounded.
struct ContactTrace {
  Contact contact;
  ContactKind kind = ContactKind::segment;

  /// Of a segment, in the direction n_a x n_b of the triangles' normals; of a point twice that.
  /// Each coordinate is off by less than 2^-23 times the largest coordinate of the two triangles.
  /// Without ends, both are the middle of the two triangles' centres.
  Vec3 from, to;

  /// Of length 1, the direction in which a should move to leave b: half way between the normal of
  /// b's triangle and the opposite of a's; that of b's alone where these are opposites, and zero
  /// where that has collapsed.
  Vec3 normal;

  /// How far a's triangle reaches behind b's along `normal`: moved by that, it would touch it at
  /// most. It is never more than the triangles are large, so it shrinks when they are cut; how deep
  /// bodies are in each other is another question.
  float depth = 0;

  /// The joints that the triangles follow most, by the weights of their corners together; of equal
  /// ones the lowest.
  std::uint16_t joint_a = 0, joint_b = 0;
};

/// One step along a curve.
struct CurveStep {
  std::uint32_t trace = 0;   ///< into ContactGeometry::traces
  bool is_reversed = false;  ///< it is walked from `to` to `from`
};

/// Segments that follow one another. Each two share an end, which is the same to the bit.
struct ContactCurve {
  std::uint32_t first = 0, count = 0;  ///< into ContactGeometry::steps
  bool is_closed = false;              ///< the last segment leads to where the first begins
};

/// Contacts that hang together: each shares a triangle with another one, whose other triangle
/// shares a corner with its own.
struct ContactRegion {
  std::uint32_t first = 0, count = 0;  ///< into ContactGeometry::members
  float length = 0;                    ///< of all segments together
  Vec3 point;                          ///< mean of the traces' middles, by their lengths
  Vec3 normal;      ///< mean of the traces' normals likewise, of length 1; zero if they cancel
  float depth = 0;  ///< the largest of the traces'
  std::uint16_t joint_a = 0, joint_b = 0;  ///< that most of the contacts name
};

/// Memory that is reused: one that has been written before allocates only for more contacts.
struct ContactGeometry {
  std::vector<ContactTrace> traces;    ///< one for each contact, in their order
  std::vector<CurveStep> steps;        ///< of the curves, one curve after the other
  std::vector<ContactCurve> curves;    ///< of all segments, each once
  std::vector<std::uint32_t> members;  ///< of the regions, into `traces`, ascending in each
  std::vector<ContactRegion> regions;  ///< the one with the most contacts first
};

/// Writes the geometry of contacts that `collide(a, b, ...)` found in the poses as they are now,
/// in place of what `geometry` had.
///
/// Curves are chained by the features that cut each other, not by coordinates, so they are
/// complete: two closed surfaces in general position cut each other in closed curves. They end at
/// the border of a surface that is not closed, and where more than two segments meet, as happens
/// where edges lie in faces, corners on edges, or surfaces have parts in common.
///
/// Preconditions: `surface_a` and `surface_b` are of the models of `a` and `b` (the surface of
/// another model aborts the program, in every build); the contacts are ascending, without
/// repetition, and in range. O(C log C) for C contacts; nodes that are not open are opened.
PELT_API QueryStats describe_contacts(Pose& a, const Surface& surface_a, Pose& b,
                                      const Surface& surface_b, std::span<const Contact> contacts,
                                      Scratch& scratch, ContactGeometry& geometry);

}  // namespace pelt
