#pragma once

/// What all queries share: how their work is counted, and the memory lent to them.

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

/// The work that a query did, in counts that do not depend on the machine. Every query returns its
/// work, all of it; add up several by `+=`.
struct QueryStats {
  /// Nodes compared with what is asked: another tree's node, a ray, a point, a region. The roots
  /// are included.
  std::uint64_t node_pairs = 0;
  std::uint64_t refits = 0;          ///< boxes computed for the current joint palettes
  std::uint64_t posed_vertices = 0;  ///< vertices skinned, once for each node that has them
  std::uint64_t triangle_pairs = 0;  ///< triangles compared with the same, because boxes overlap
  std::uint64_t displacements = 0;   ///< by active morph targets, of vertices that were posed
  bool cut_short = false;            ///< a limit of the options ended the query before its end

  PELT_API QueryStats& operator+=(const QueryStats& other);
};

/// The answer to a question of yes or no, with the work that it took:
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

/// Memory lent to queries so that they allocate nothing after the first ones: one for each thread.
/// Its content carries nothing from one query to the next.
class PELT_API Scratch {
 public:
  Scratch();
  Scratch(Scratch&&) noexcept;
  Scratch& operator=(Scratch&&) noexcept;
  ~Scratch();

  /// Takes at once all the memory that queries with up to so many contacts could want, found or
  /// allowed by `max_contacts`, whatever the models; 1 is enough for `intersects`. A triangle that
  /// is found in a region counts as one contact. With poses that have been reserved too, and room
  /// in the caller's vector, such queries allocate nothing, from the first on. 156 KB and 28 bytes
  /// a contact.
  ///
  /// The same for `cast_all` of rays with up to `ray_hits` hits: 36 bytes each.
  void reserve(std::size_t contacts, std::size_t ray_hits = 0);

  /// For Pelt's own files.
  detail::Scratch& detail() { return *scratch_; }

 private:
  std::unique_ptr<detail::Scratch> scratch_;
};

}  // namespace pelt
