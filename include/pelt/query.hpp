#pragma once

/// What all queries share: work counters, and reusable memory.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
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

  /// Vertices skinned; a vertex counts once for each node that has it.
  std::uint64_t posed_vertices = 0;

  std::uint64_t triangle_pairs = 0;  ///< triangle tests, made because boxes overlap
  std::uint64_t displacements = 0;   ///< displacements of posed vertices by active morph targets
  bool cut_short = false;            ///< a limit in the options ended the query early

  PELT_API QueryStats& operator+=(const QueryStats& other);
};

/// A yes-or-no answer, with the work of the query:
///
///     if (intersects(a, b, scratch)) ...
///     total += intersects(a, b, scratch);
struct YesNo : QueryStats {
  bool answer = false;

  explicit operator bool() const { return answer; }
};

/// Where in the tree of a model a query found its answer, for functions that go on from there.
/// Opaque: it has no meaning outside of Pelt.
template <std::size_t kNumbers>
class TreeLocation {
 public:
  friend bool operator==(const TreeLocation&, const TreeLocation&) = default;

 private:
  friend struct detail::Access;
  std::array<std::uint32_t, kNumbers> numbers_ = {};
};

/// Working memory for queries. A query allocates from it only if it needs more than all earlier
/// queries. Use one for each thread. Answers do not depend on earlier uses of it.
class PELT_API Scratch {
 public:
  Scratch();
  Scratch(Scratch&&) noexcept;
  Scratch& operator=(Scratch&&) noexcept;
  ~Scratch();

  /// Allocates all memory that queries can need for results of the given sizes, whatever the
  /// models. With reserved poses and room in the caller's vectors, such queries never allocate.
  ///
  /// `contacts`: largest number of contacts that are found, or allowed by `max_contacts`; 1
  ///   suffices for `intersects`. A triangle found in a region counts as a contact. Takes 156 KB
  ///   and 28 bytes per contact.
  /// `ray_hits`: largest number of hits of `cast_all`. Takes 36 bytes per hit.
  void reserve(std::size_t contacts, std::size_t ray_hits = 0);

  /// For internal use.
  detail::Scratch& detail() { return *scratch_; }

 private:
  std::unique_ptr<detail::Scratch> scratch_;
};

}  // namespace pelt
