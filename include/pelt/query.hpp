#pragma once

/// Contacts, limits, work counters and reusable memory, common to all queries.
///
/// Results: a query with one result overwrites the caller's object. A query that finds a list
/// appends to the caller's vectors. `describe_contacts` is an exception: it replaces the contents
/// of its result. A query with one result for each ray, point or pose writes to a span. A query
/// that answers yes or no returns `YesNo`.
///
/// Allocation: a query with a `Scratch` allocates only if it needs more memory in the poses, in the
/// scratch or in the caller's vectors than any earlier query. A query without a `Scratch` allocates
/// at most in the pose and in the vectors to which it appends. `Crowd` has its own memory. Queries
/// that need the surface of a model make it, once (`SkinnedModel::surface`).

#include <pelt/config.hpp>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

namespace pelt {

namespace detail {
struct Access;
struct Scratch;
}  // namespace detail

/// Work done by a query, in counts that do not depend on the machine. Each query returns its own
/// work; add up the work of several queries with `+=`.
struct QueryStats {
  /// Tests of a node against the other operand: a node of another tree, a ray, a point or a region.
  /// Includes the roots.
  std::uint64_t node_pairs = 0;

  std::uint64_t refits = 0;  ///< boxes computed for the current joint palettes

  /// Vertices skinned. Triangles of different nodes may share a vertex, which is then skinned and
  /// counted once per node.
  std::uint64_t posed_vertices = 0;

  std::uint64_t triangle_pairs = 0;  ///< tests of a triangle against the other operand
  std::uint64_t displacements = 0;   ///< displacements that morph targets added to vertices

  /// Offsets that were clamped when nodes were opened: those beyond their cap, and NaN. Counted
  /// like `posed_vertices`.
  std::uint64_t clamped_offsets = 0;

  bool cut_short = false;  ///< a limit in the options ended the query early

  PELT_API QueryStats& operator+=(const QueryStats& other);
};

/// The work of a query in units of about one test of two triangles: the counts of QueryStats,
/// multiplied by the constants of pelt/search.hpp.
PELT_API std::uint64_t work_of(const QueryStats& stats);

/// Two triangles that a query has found, as indices into the triangle arrays of the two models.
/// They intersect, or are within the tolerance of `clearance`.
struct Contact {
  std::uint32_t triangle_a = 0, triangle_b = 0;

  friend auto operator<=>(const Contact&, const Contact&) = default;
};

/// Limits of a query. A query without contacts ignores `max_contacts`, and one without distances
/// `max_distance`.
struct Limits {
  /// Stop after this number of contacts. Which contacts are found first is unspecified;
  /// `QueryStats::cut_short` says whether any may be missing.
  std::uint32_t max_contacts = std::numeric_limits<std::uint32_t>::max();

  /// Ignore everything farther away. A negative or NaN value aborts the program, in every build.
  double max_distance = std::numeric_limits<double>::infinity();
};

/// A yes-or-no answer, with the work of the query:
///
///     if (intersects(a, b, scratch)) ...
///     total += intersects(a, b, scratch);
struct YesNo : QueryStats {
  bool answer = false;

  explicit operator bool() const { return answer; }
};

/// Where in the trees of the models a result was found. Only Pelt reads the location, when the
/// result that contains it is passed to another query: a `Distance` as `DistanceOptions::hint`, or
/// a `RayHit` to `influences_at`.
template <std::size_t kNumbers>
class TreeLocation {
 public:
  friend bool operator==(const TreeLocation&, const TreeLocation&) = default;

 private:
  friend struct detail::Access;
  std::array<std::uint32_t, kNumbers> numbers_ = {};
};

/// Size of the working memory of self-collision with one filter, see `SelfFilter::scratch_size`.
struct SelfScratchSize {
  std::size_t vertices = 0;   ///< each takes 40 bytes
  std::size_t box_bytes = 0;  ///< bytes for boxes of triangles, about 20 per triangle
  std::size_t triangles = 0;  ///< each takes 8 bytes
};

/// Working memory for queries. A query enlarges the memory only if it needs more than any earlier
/// query. Use one Scratch per thread. Answers do not depend on earlier uses.
class PELT_API Scratch {
 public:
  Scratch();
  Scratch(Scratch&&) noexcept;
  Scratch& operator=(Scratch&&) noexcept;
  ~Scratch();

  /// Allocates the memory that queries need for results of the given sizes, for models of any size.
  /// Queries within these sizes never allocate if the poses are reserved, too, and the caller's
  /// vectors have enough capacity. `describe_contacts` is an exception: it also needs memory that
  /// is not reserved here, so it allocates in its first call and whenever there are more contacts
  /// than in any earlier call.
  ///
  /// `contacts`: largest number of contacts that a query finds or that its limit allows; 1 for
  ///   `intersects`. Triangles found in a region count as contacts. For `distance`, all pairs or
  ///   triangles that touch count, although the query reports only one.
  /// `ray_hits`: largest number of hits of `cast_all`.
  /// `self`: `SelfFilter::scratch_size` of the filter of `self_collide`. For several filters, call
  ///   `reserve` once for each. `self_intersection_volume` needs the size of any filter of the
  ///   model.
  ///
  /// Memory: 192 KB, plus 92 bytes per contact, 36 bytes per hit and what `self` states. With
  /// `self`, each contact takes another 48 bytes.
  void reserve(std::size_t contacts, std::size_t ray_hits = 0, const SelfScratchSize& self = {});

  /// For internal use.
  detail::Scratch& detail() { return *scratch_; }

 private:
  std::unique_ptr<detail::Scratch> scratch_;
};

}  // namespace pelt
