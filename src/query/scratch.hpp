#pragma once

#include "query/stack.hpp"

#include <pelt/collide.hpp>
#include <pelt/ray.hpp>

#include <cstdint>

namespace pelt::detail {

/// Two nodes whose boxes overlap as far as is known, and the slots of each that are still to be
/// compared with the other's.
struct SlotPair {
  std::uint32_t node_a, slots_a, node_b, slots_b;
  bool b_is_parent = false;  // a is a child of the node that overlapped b, b has yet to follow
  float depth = 0;           // how far the boxes overlap
};

/// A part of a tree that may hold the nearest point, and how far its box is.
struct NearPart {
  float squared_gap;
  std::uint32_t node, slot;
};

/// The same of two trees.
struct NearParts {
  float squared_gap;
  std::uint32_t node_a, slot_a, node_b, slot_b;
};

/// Memory lent to queries; every user clears what it takes.
struct Scratch {
  Stack<SlotPair> slot_pairs;
  Stack<NearPart> near_part;
  Stack<NearParts> near_parts;
  Stack<Contact> found, sorting;
  Stack<RayHit> ray_hits;
  Stack<std::uint32_t> nodes;             // to be visited
  Stack<std::uint32_t> touching, inside;  // triangles of a region
  Stack<std::uint32_t> sorting_numbers;
};

}  // namespace pelt::detail
