#pragma once

/// The filter of pairs of triangles by their main joints and zones.

#include <pelt/self_filter.hpp>

#include "self/pair_set.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Triangles with the same body and the same zones are of one kind. A character has few kinds, so a
/// triangle needs two bytes.
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

}  // namespace pelt::detail
