#pragma once

#include "base/arena.hpp"
#include "query/stack.hpp"

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>
#include <pelt/ray.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Two nodes whose boxes may overlap, with the slots of each that have not been compared yet.
struct SlotPair {
  std::uint32_t node_a, slots_a, node_b, slots_b;
  bool b_is_parent = false;  // a was replaced by a child; b is still to be replaced
  float depth = 0;           // depth by which the boxes overlap
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
  std::uint32_t triangle = 0;
  std::array<std::int32_t, 2> to = {};
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
};

}  // namespace pelt::detail
