#pragma once

/// Kavan & Zara 2005, section 4.2: "the standard algorithm". Descends two sphere trees
/// simultaneously. If two spheres overlap, the children of the larger one are tested against the
/// other, down to pairs of leaves, whose triangles are tested exactly.
///
/// A side provides `tree()`, `sphere(node)` and `corners(leaf)`. The descent calls `refresh(first,
/// end)` before it uses the spheres of these nodes. The paper's method refits there, that is, just
/// prior to the sphere test; its rivals have refitted before.

#include "geometry/triangle_pair.hpp"
#include "paper/ball.hpp"
#include "paper/scratch.hpp"
#include "paper/sphere_tree.hpp"

#include <pelt/collide.hpp>

#include <algorithm>
#include <vector>

namespace pelt::paper {

template <class SideA, class SideB>
class Descent {
 public:
  Descent(SideA& a, SideB& b, Scratch& scratch, std::vector<Contact>& contacts,
          std::uint32_t max_contacts)
      : a_(a), b_(b), stack_(scratch.node_pairs), contacts_(contacts), left_(max_contacts) {}

  /// Appends all contacts, or the first `max_contacts` that it finds.
  QueryStats run() {
    start();
    while (waiting_ > 0 && left_ > 0) {
      const auto [node_a, node_b] = stack_[--waiting_];
      open(node_a, node_b);
    }
    stats_.cut_short = waiting_ > 0;
    return stats_;
  }

 protected:
  using NodePair = std::pair<std::uint32_t, std::uint32_t>;

  void start() {
    ++stats_.node_pairs;
    make_room(1);
    stack_[0] = {0, 0};
    a_.refresh(0, 1);
    b_.refresh(0, 1);
    waiting_ = balls_meet(a_.sphere(0), b_.sphere(0));
  }

  void open(std::uint32_t node_a, std::uint32_t node_b) {
    const Node& a = a_.tree().nodes[node_a];
    const Node& b = b_.tree().nodes[node_b];
    if (a.is_leaf() && b.is_leaf()) {
      test_triangles(a, b);
    } else if (b.is_leaf() || (!a.is_leaf() && larger_is_a(node_a, node_b))) {
      test_children(a_, a, b_.sphere(node_b),
                    [&](std::uint32_t child) { return NodePair(child, node_b); });
    } else {
      test_children(b_, b, a_.sphere(node_a),
                    [&](std::uint32_t child) { return NodePair(node_a, child); });
    }
  }

  /// Pushes the pairs whose spheres overlap. Writes every pair and counts only the overlapping
  /// ones, because a processor cannot predict whether two spheres overlap.
  template <class Side, class MakePair>
  void test_children(Side& side, const Node& parent, const Float4& other, MakePair make_pair) {
    stats_.node_pairs += parent.child_count;
    make_room(parent.child_count);
    const std::uint32_t end = parent.first_child + parent.child_count;
    side.refresh(parent.first_child, end);
    for (std::uint32_t first = parent.first_child; first < end; first += 4) {
      const auto sphere = [&](std::uint32_t i) {
        return side.sphere(std::min(first + i, end - 1));
      };
      const Float4 gaps =
          gaps_between(balls_side_by_side(sphere(0), sphere(1), sphere(2), sphere(3)), other);
      for (std::uint32_t i = 0; i < std::min(end - first, 4u); ++i) {
        stack_[waiting_] = make_pair(first + i);
        waiting_ += gaps[static_cast<int>(i)] <= 0;
      }
    }
  }

  void make_room(std::size_t count) {
    if (stack_.size() < waiting_ + count) stack_.resize(2 * (waiting_ + count));
  }

  bool larger_is_a(std::uint32_t node_a, std::uint32_t node_b) {
    return a_.sphere(node_a)[3] >= b_.sphere(node_b)[3];
  }

  void test_triangles(const Node& leaf_a, const Node& leaf_b) {
    ++stats_.triangle_pairs;
    if (!detail::triangles_intersect(a_.corners(leaf_a), b_.corners(leaf_b))) return;
    contacts_.push_back(
        Contact{a_.tree().triangle_of_leaf(leaf_a), b_.tree().triangle_of_leaf(leaf_b)});
    --left_;
  }

  SideA& a_;
  SideB& b_;
  std::vector<NodePair>& stack_;
  std::size_t waiting_ = 0;  // pairs on the stack
  std::vector<Contact>& contacts_;
  std::uint32_t left_;
  QueryStats stats_;
};

template <class SideA, class SideB>
QueryStats descend(SideA& a, SideB& b, Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts) {
  return Descent<SideA, SideB>(a, b, scratch, contacts, max_contacts).run();
}

}  // namespace pelt::paper
