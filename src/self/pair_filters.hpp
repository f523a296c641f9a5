#pragma once

/// Filters of pairs of triangles: by sets of pairs, by rings, and by main joints and zones.

#include <pelt/self_filter.hpp>

#include "query/stack.hpp"
#include "self/fans.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

void sort_unique(std::vector<std::uint64_t>& numbers);

/// A set of unordered pairs of numbers. Pairs are packed into integers, so that sets of all kinds
/// of numbers share one instance of std::sort, which takes kilobytes.
class PairSet {
 public:
  using value_type = std::uint64_t;

  void reserve(std::size_t count) { pairs_.reserve(count); }
  void add(std::uint32_t a, std::uint32_t b) { pairs_.push_back(packed(a, b)); }

  /// Sorts the pairs and removes repetitions. Call this after the last `add`.
  void finish();

  bool empty() const { return pairs_.empty(); }
  bool contains(std::uint32_t a, std::uint32_t b) const;
  std::size_t capacity() const { return pairs_.capacity(); }

 private:
  static std::uint64_t packed(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
  }

  std::vector<std::uint64_t> pairs_;
};

/// A filter of pairs of triangles by their main joints and zones. Triangles with the same body and
/// the same zones are of one kind. A character has few kinds, so a triangle needs two bytes.
class JointFilter {
 public:
  /// Precondition: the options are valid for the model.
  JointFilter(const SkinnedModel& model, const SelfFilterOptions& options);

  /// Whether the filter leaves out a pair of triangles.
  bool leaves_out(std::uint32_t s, std::uint32_t t) const;

  std::size_t memory_bytes() const;

 private:
  struct Kind {
    std::uint16_t body;
    std::uint32_t zones_begin, zones_end;  // into `zones_`, ascending
  };

  void find_kinds(std::span<const std::uint16_t> bodies, std::span<const TriangleZone> zones);
  const Kind& kind_of(std::uint32_t triangle) const;
  bool share_zone(const Kind& a, const Kind& b) const;

  PairSet pairs_, pairs_in_zones_;   // of bodies
  std::vector<std::uint16_t> low_;   // [T] the low bits of the number of the triangle's kind, or
                                     // empty if there are no pairs
  std::vector<std::uint16_t> high_;  // [T] the high bits, or empty if all are 0
  std::vector<Kind> kinds_;
  std::vector<std::uint16_t> zones_;
};

inline constexpr std::uint32_t kMaxRings = 64;

/// Arrays [T] are indexed by the caller's triangle numbers.
struct PairFilters {
  /// Precondition: the options are valid for the model.
  PairFilters(const SkinnedModel& model, const Fans& fans, const SelfFilterOptions& options);

  /// The first filter that leaves out a pair of different triangles. `ring` is working memory:
  /// empty, or from the last call for this object.
  LeftOutBy left_out_by(const Tree& tree, const Fans& fans, Contact pair,
                        Stack<std::uint32_t>& ring) const;

  std::uint32_t rings = 0;
  std::vector<std::uint32_t> fan_of_vertex;  // by surface vertex; empty unless rings > 1
  std::vector<bool> takes_part;              // [T] or empty
  PairSet at_rest, always;                   // of triangles
  JointFilter joints;
  std::vector<std::uint16_t> groups;  // [T] or empty
  PairSet group_pairs;

 private:
  bool are_within_rings(const Tree& tree, const Fans& fans, Contact pair,
                        Stack<std::uint32_t>& ring) const;
};

}  // namespace pelt::detail
