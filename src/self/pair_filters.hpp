#pragma once

/// The filters of self-collision: which pairs of triangles are left out of the answer.

#include <pelt/self_filter.hpp>

#include "query/stack.hpp"
#include "self/fans.hpp"
#include "self/joint_filter.hpp"
#include "self/pair_set.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

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
