#pragma once

/// Working memory of queries.

#include "base/arena.hpp"
#include "query/stack.hpp"

#include <pelt/motion.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Two nodes whose boxes may overlap, with the slots of each that have not been compared yet.
struct SlotPair {
  std::uint32_t node_a, slots_a, node_b, slots_b;
  bool b_is_parent = false;  // a was replaced by a child; b is still to be replaced
  float depth = 0;           // what the rule visits first (PairDescent)
};

/// A part of a tree that may contain the closest point, with the distance of its box.
struct NearPart {
  float squared_gap;
  std::uint32_t node, slot;
};

/// The same for two trees.
struct NearParts {
  float squared_gap;
  std::uint32_t node_a, slot_a, node_b, slot_b;
};

/// Working memory of describing contacts (src/contact): sorted keys that neighbours share, and
/// numbers for each trace or end.
struct ContactLinks {
  struct Link {
    std::array<std::uint32_t, 6> key;
    std::uint32_t owner;
  };
  std::vector<Link> links;
  std::vector<std::uint32_t> partners, labels;
};

/// How much greater the winding number of another surface is at corners 1 and 2 of a triangle than
/// at corner 0.
struct WindingTurns {
  std::uint32_t place = 0;  ///< of the triangle
  std::array<std::int32_t, 2> to = {};
};

/// How much greater the winding number in front of a triangle is at later points of its outline
/// than at point 0. Points 2 i and 2 i + 1 are the start and the end of edge i.
struct OutlineTurns {
  std::uint32_t place = 0;                 ///< of the triangle
  std::array<std::int32_t, 5> after = {};  ///< at points 1 to 5

  std::int32_t at(std::size_t point) const { return point == 0 ? 0 : after[point - 1]; }
};

/// Working memory of queries. Every user clears the parts that it uses.
struct Scratch {
  Stack<SlotPair> slot_pairs;
  Stack<NearPart> near_part;
  Stack<NearParts> near_parts;
  Stack<Contact> found, sorting;
  Stack<MovingContact> moving, sorting_moving;
  Stack<RayHit> ray_hits;
  Stack<std::uint32_t> nodes;             // to be visited
  Stack<std::uint32_t> touching, inside;  // triangles of a region
  Stack<std::uint32_t> sorting_numbers;
  Stack<std::array<float, 4>> positions;  // posed vertices by place
  Stack<std::uint32_t> ring;              // surface vertices near a triangle
  Arena boxes;                            // of clusters on a grid (self/grid_boxes.hpp)
  ContactLinks contact_links;
  Stack<WindingTurns> turns_a, turns_b;  // of triangles that cross another body
  Stack<OutlineTurns> outline_turns;     // of triangles that cross their own body
  Stack<std::uint32_t> turns_of;         // [T] one plus the index into outline_turns, or 0
  Stack<std::int32_t> fronts;            // [T] winding numbers in front of triangles

  static constexpr std::size_t kStackCount = 19;

  /// Calls `visit(stack)` with each stack. `AnyScratch`: const or not.
  template <typename AnyScratch, typename Visit>
  static void each(AnyScratch& s, const Visit& visit) {
    const auto visit_all = [&](auto&... stacks) {
      static_assert(sizeof...(stacks) == kStackCount);
      (visit(stacks), ...);
    };
    visit_all(s.slot_pairs, s.near_part, s.near_parts, s.found, s.sorting, s.moving,
              s.sorting_moving, s.ray_hits, s.nodes, s.touching, s.inside, s.sorting_numbers,
              s.positions, s.ring, s.turns_a, s.turns_b, s.outline_turns, s.turns_of, s.fronts);
  }
};

}  // namespace pelt::detail
