#pragma once

#include <pelt/pose.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace pelt {

namespace detail {
struct Scratch;
}

/// Two triangles that intersect, by their numbers in the two models' triangle arrays.
struct Contact {
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const Contact&, const Contact&) = default;
};

struct CollideOptions {
  /// Stop after this many contacts. Which ones are found first is unspecified, and
  /// `QueryStats::cut_short` says whether any may be missing. 0 is allowed: nothing is looked for,
  /// and `cut_short` says whether the boxes around the two poses overlap.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();
};

/// The work that a query did, in counts that do not depend on the machine.
struct QueryStats {
  std::uint64_t node_pairs = 0;      ///< pairs of tree nodes compared, those of the roots included
  std::uint64_t refits = 0;          ///< boxes computed for the current joint palettes
  std::uint64_t posed_vertices = 0;  ///< vertices skinned, once for each node that has them
  std::uint64_t triangle_pairs = 0;  ///< pairs of triangles tested, because their boxes overlap
  bool cut_short = false;            ///< `max_contacts` ended the query before its end

  QueryStats& operator+=(const QueryStats& other);
};

/// Memory lent to queries so that they allocate nothing after the first ones: one for each thread.
/// Its content carries nothing from one query to the next.
class Scratch {
 public:
  Scratch();
  Scratch(Scratch&&) noexcept;
  Scratch& operator=(Scratch&&) noexcept;
  ~Scratch();

  /// Takes at once all the memory that queries with up to so many contacts could want, found or
  /// allowed by `max_contacts`, whatever the models; 1 is enough for `intersects`. With poses that
  /// have been reserved too, and room in the caller's vector, such queries allocate nothing, from
  /// the first on. 113 KB and 16 bytes a contact.
  void reserve(std::size_t contacts);

  /// For Pelt's own files.
  detail::Scratch& detail() { return *scratch_; }

 private:
  std::unique_ptr<detail::Scratch> scratch_;
};

/// Appends every pair of triangles of `a` and `b` that intersect, in ascending order.
///
/// Exact with respect to the float32 posed vertices (see `posed_vertices`): triangles are closed
/// sets, so touching counts as intersecting, coplanar overlap counts, and a triangle that has
/// collapsed to a segment or a point is treated as that segment or point.
///
/// Precondition: `a` and `b` are different poses (of the same model or of two). Cost grows with the
/// contact, not with the meshes: two trees of boxes are descended together, and only where boxes
/// meet are vertices posed and boxes computed, each once until the next palette. Poses that are far
/// apart cost O(J). That boxes wait until they are asked for is Kavan & Zara 2005, section 4.2;
/// tree and boxes are Pelt's own.
QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const CollideOptions& options = {});

/// Whether any triangles of `a` and `b` intersect; as `collide`, stopping at the first contact.
bool intersects(Pose& a, Pose& b, Scratch& scratch);

}  // namespace pelt
