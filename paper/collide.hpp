#pragma once

/// Kavan & Zara 2005, section 4.2: "the standard algorithm". Two sphere trees are descended
/// together; where two spheres overlap, the children of the larger one are tested against the
/// other, down to pairs of leaves, whose triangles are tested exactly.
///
/// A side answers three questions: `tree()`, `sphere(node)` and `triangle(t)`. The paper's method
/// refits inside `sphere(node)`, that is, just prior to the sphere test; its rivals look it up.

#include "base/scratch.hpp"
#include "geometry/triangle_pair.hpp"
#include "paper/ball.hpp"
#include "paper/sphere_tree.hpp"

#include <vector>

namespace pelt::paper {

using detail::Scratch;

template <class SideA, class SideB>
class Descent {
 public:
  Descent(SideA& a, SideB& b, Scratch& scratch, std::vector<Contact>& contacts,
          std::uint32_t max_contacts)
      : a_(a), b_(b), stack_(scratch.node_pairs), contacts_(contacts), left_(max_contacts) {}

  /// Appends contacts until all are found or `max_contacts` of them.
  QueryStats run() {
    stack_.clear();
    visit(0, 0);
    while (!stack_.empty() && left_ > 0) {
      const auto [node_a, node_b] = stack_.back();
      stack_.pop_back();
      open(node_a, node_b);
    }
    stats_.cut_short = !stack_.empty();
    return stats_;
  }

 private:
  /// Keeps a pair of nodes for later if their spheres overlap.
  void visit(std::uint32_t node_a, std::uint32_t node_b) {
    ++stats_.node_pairs;
    if (balls_meet(a_.sphere(node_a), b_.sphere(node_b))) stack_.emplace_back(node_a, node_b);
  }

  void open(std::uint32_t node_a, std::uint32_t node_b) {
    const Node& a = a_.tree().nodes[node_a];
    const Node& b = b_.tree().nodes[node_b];
    if (a.is_leaf() && b.is_leaf()) {
      test_triangles(a_.tree().triangle_of_leaf(a), b_.tree().triangle_of_leaf(b));
    } else if (b.is_leaf() || (!a.is_leaf() && larger_is_a(node_a, node_b))) {
      for (std::uint32_t c = 0; c < a.child_count; ++c) visit(a.first_child + c, node_b);
    } else {
      for (std::uint32_t c = 0; c < b.child_count; ++c) visit(node_a, b.first_child + c);
    }
  }

  bool larger_is_a(std::uint32_t node_a, std::uint32_t node_b) {
    return a_.sphere(node_a)[3] >= b_.sphere(node_b)[3];
  }

  void test_triangles(std::uint32_t triangle_a, std::uint32_t triangle_b) {
    ++stats_.triangle_pairs;
    if (!detail::triangles_intersect(a_.triangle(triangle_a), b_.triangle(triangle_b))) return;
    contacts_.push_back(Contact{triangle_a, triangle_b});
    --left_;
  }

  SideA& a_;
  SideB& b_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>& stack_;
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
