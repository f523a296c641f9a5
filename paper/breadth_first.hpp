#pragma once

/// The descent of section 4.2, one level of the trees after the other, so that it can be stopped:
/// Hubbard, *Approximating Polyhedra with Spheres for Time-Critical Collision Detection* (1996),
/// with the exact test of triangles in place of the approximation by the spheres of a level.

#include "paper/collide.hpp"

#include <cstddef>
#include <limits>

namespace pelt::paper {

/// Pairs of spheres that overlap wait in a queue:
///
///     opened | front_: next ... | waiting_: end
template <class SideA, class SideB>
class BreadthFirst : private Descent<SideA, SideB> {
 public:
  /// Starts with the roots. Appends contacts in no particular order.
  BreadthFirst(SideA& a, SideB& b, Scratch& scratch, std::vector<Contact>& contacts)
      : Descent<SideA, SideB>(a, b, scratch, contacts, std::numeric_limits<std::uint32_t>::max()) {
    this->start();
  }

  bool is_complete() const { return front_ == this->waiting_; }

  /// Replaces the next pair by pairs of children, or tests its triangles. Precondition: not
  /// complete.
  void step() {
    const auto [node_a, node_b] = this->stack_[front_++];
    this->open(node_a, node_b);
  }

  /// Node pairs and triangle pairs so far.
  const QueryStats& stats() const { return this->stats_; }

  /// Calls `visit(node_a, node_b)` for each pair that waits.
  template <typename Visit>
  void each_open(const Visit& visit) const {
    for (std::size_t i = front_; i < this->waiting_; ++i)
      visit(this->stack_[i].first, this->stack_[i].second);
  }

 private:
  std::size_t front_ = 0;
};

}  // namespace pelt::paper
