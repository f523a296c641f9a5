#pragma once

/// Descends two trees of boxes simultaneously: four children of two nodes are tested together, down
/// to pairs of leaves, where the boxes of triangles are compared.
///
/// A side provides `node(n)`, `triangle(i)` and `id(i)` of the i-th triangle in the tree's order,
/// and `points()`. The descent calls `open(n)` before it uses the boxes of the node's children.

#include "evaluation/rivals/box_tree.hpp"
#include "evaluation/rivals/pair_tests.hpp"

#include <utility>
#include <vector>

namespace pelt::rivals {

/// Memory for descents, so that they allocate nothing after the first ones.
using NodePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

template <class SideA, class SideB>
class BoxDescent {
 public:
  BoxDescent(SideA& a, SideB& b, NodePairs& stack, PairTests& tests)
      : a_(a), b_(b), stack_(stack), tests_(tests) {}

  /// Returns the number of pairs of boxes compared, without the boxes of triangles.
  std::uint64_t run() {
    make_room();
    test(0, 0);
    while (waiting_ > 0 && !tests_.full()) {
      const auto [a, b] = stack_[--waiting_];
      make_room();
      open(a, b);
    }
    return compared_;
  }

 private:
  void open(std::uint32_t node_a, std::uint32_t node_b) {
    const BoxNode& a = a_.node(node_a);
    const BoxNode& b = b_.node(node_b);
    if (a.count > 0 && b.count > 0) return compare_triangles(a, b);
    if (a.count == 0) a_.open(node_a);
    if (b.count == 0) b_.open(node_b);
    if (a.count > 0) {
      test(node_a, b.first), test(node_a, b.first + 1);
    } else if (b.count > 0) {
      test(a.first, node_b), test(a.first + 1, node_b);
    } else {
      test(a.first, b.first), test(a.first, b.first + 1);
      test(a.first + 1, b.first), test(a.first + 1, b.first + 1);
    }
  }

  /// Pushes a pair if its boxes overlap. Writes the pair in any case, because a processor cannot
  /// predict whether they overlap.
  void test(std::uint32_t node_a, std::uint32_t node_b) {
    ++compared_;
    stack_[waiting_] = {node_a, node_b};
    waiting_ += overlap(a_.node(node_a).box(), b_.node(node_b).box());
  }

  void make_room() {
    constexpr std::size_t kChildPairs = 4;
    if (stack_.size() < waiting_ + kChildPairs) stack_.resize(2 * (waiting_ + kChildPairs));
  }

  void compare_triangles(const BoxNode& leaf_a, const BoxNode& leaf_b) {
    LeafBoxes boxes_a, boxes_b;
    boxes_a.take(a_, leaf_a, leaf_b.box());
    boxes_b.take(b_, leaf_b, leaf_a.box());
    for (std::uint32_t i = 0; i < boxes_a.count; ++i)
      for (std::uint32_t j = 0; j < boxes_b.count; ++j)
        if (overlap(boxes_a.box[i], boxes_b.box[j])) tests_.add(boxes_a.id[i], boxes_b.id[j]);
  }

  /// The triangles of a leaf whose boxes overlap the other leaf's box.
  struct LeafBoxes {
    Box4 box[kMaxLeafTriangles];
    std::uint32_t id[kMaxLeafTriangles];
    std::uint32_t count = 0;

    template <class Side>
    void take(const Side& side, const BoxNode& leaf, const Box4& other) {
      for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t) {
        box[count] = side.points().box_of(side.triangle(t));
        id[count] = side.id(t);
        count += overlap(box[count], other);
      }
    }
  };

  SideA& a_;
  SideB& b_;
  NodePairs& stack_;
  std::size_t waiting_ = 0;  // pairs on the stack
  PairTests& tests_;
  std::uint64_t compared_ = 0;
};

}  // namespace pelt::rivals
