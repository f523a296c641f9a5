/// Descent of two trees for intersecting triangles. A node is opened when a known box overlaps its
/// bound (refit on demand, Kavan & Zara 2005, section 4.2). Opening may show that the exact boxes
/// do not overlap, so one side of a pair is opened before the other.

#include "collide/collide_trees.hpp"

#include "collide/cluster_pair.hpp"
#include "query/contact_sink.hpp"
#include "query/pair_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters until there are enough contacts.
class IntersectingTriangles : public BoxOverlap {
 public:
  IntersectingTriangles(const Tree& a, const Tree& b, const ContactSink& sink, QueryStats& work)
      : sink_(sink), triangles_(a, b, sink, work) {}

  bool is_full() const { return sink_.is_full(); }
  bool is_impatient() const { return sink_.is_impatient(); }

  void test(const PosedCluster& a, const PosedCluster& b) {
    triangles_.add(a, b);
    if (is_impatient()) triangles_.flush();
  }

  void flush() { triangles_.flush(); }

 private:
  const ContactSink& sink_;
  TrianglePairs<const ContactSink> triangles_;
};

/// Also stops after a number of units of work.
class LimitedTriangles : public IntersectingTriangles {
 public:
  LimitedTriangles(const Tree& a, const Tree& b, const ContactSink& sink, QueryStats& work,
                   std::uint64_t max_work)
      : IntersectingTriangles(a, b, sink, work), work_(work), max_work_(max_work) {}

  bool is_full() const { return IntersectingTriangles::is_full() || work_of(work_) >= max_work_; }

 private:
  const QueryStats& work_;
  std::uint64_t max_work_;
};

/// Descends with the rule that `make_rule(sink, work)` returns. The result's `cut_short` says
/// whether pairs are left.
template <typename MakeRule>
QueryStats descend(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                   std::uint32_t max_contacts, const MakeRule& make_rule) {
  QueryStats work;
  scratch.found.clear();
  if (!begin_descent(a, b, work)) return work;
  const ContactSink sink(scratch.found, max_contacts);
  auto rule = make_rule(sink, work);
  const bool is_unfinished = descend_from_roots(a, b, scratch.slot_pairs, rule, work);
  rule.flush();
  work.cut_short = sink.is_full() ? sink.cut(is_unfinished) : is_unfinished;
  return work;
}

}  // namespace

QueryStats collide_trees(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return descend(a, b, scratch, max_contacts, [&](const ContactSink& sink, QueryStats& work) {
    return IntersectingTriangles(a.tree, b.tree, sink, work);
  });
}

QueryStats collide_trees_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                                std::uint32_t max_contacts, std::uint64_t max_work) {
  return descend(a, b, scratch, max_contacts, [&](const ContactSink& sink, QueryStats& work) {
    return LimitedTriangles(a.tree, b.tree, sink, work, max_work);
  });
}

namespace {

/// A node, and the lowest number of the triangles below each slot. Null for a node of `b`.
struct NumberedNode {
  const OpenedNode& opened;
  const std::uint32_t* lowest;
};

/// A posed tree as a View of PairDescent.
struct NumberedTree {
  const PosedTree& posed;
  const Tree& tree;
  bool is_numbered;
};

NumberedNode open_node(const NumberedTree& view, std::uint32_t node, QueryStats& work) {
  return {open_node(view.posed, node, work),
          view.is_numbered ? view.tree.lowest_below[node].data() : nullptr};
}

struct NumberedCluster {
  const NumberedTree& view;
  const Node& node;
  NumberedNode opened;
  std::uint32_t slot;

  PosedCluster posed() const { return {view.posed, node, opened.opened, slot}; }
};

/// Finds the lowest pair of intersecting triangles. Slots of `a` with lower triangles are visited
/// first. Slots whose triangles are all above the lowest found so far are pruned.
class LowestContact {
 public:
  LowestContact(const Tree& a, const Tree& b, Stack<Contact>& found, QueryStats& work)
      : found_(found), triangles_(a, b, found, work) {}

  static bool is_full() { return false; }
  static bool is_impatient() { return true; }

  static bool overlaps(const NumberedNode& a, const NumberedNode& b) {
    return BoxOverlap::overlaps(a.opened, b.opened);
  }

  unsigned slots_near(const NumberedNode& of, const NumberedNode& all) const {
    return BoxOverlap::slots_near(of.opened, all.opened) & not_above(of);
  }

  unsigned slots_near(const NumberedNode& of, const NumberedNode& other, unsigned slot) const {
    return BoxOverlap::slots_near(of.opened, other.opened, slot) & not_above(of);
  }

  /// Slots of `a` in the order of their lowest triangles, and slots of `b` after the clusters of
  /// `a` that they are compared with.
  static float depth(const NumberedNode& of, unsigned slot, const NumberedNode& other) {
    return -static_cast<float>(of.lowest != nullptr ? of.lowest[slot] : lowest_of(other));
  }

  void test(const NumberedCluster& a, const NumberedCluster& b) {
    triangles_.add(a.posed(), b.posed());
    triangles_.flush();
    for (const Contact& contact : found_)
      if (!lowest_ || contact < *lowest_) lowest_ = contact;
    found_.clear();
  }

  const std::optional<Contact>& lowest() const { return lowest_; }

 private:
  static std::uint32_t lowest_of(const NumberedNode& node) {
    std::uint32_t lowest = node.lowest[0];
    for (unsigned slot = 1; slot < kMaxSlots; ++slot)
      if (node.lowest[slot] < lowest) lowest = node.lowest[slot];
    return lowest;
  }

  /// The slots that may have a triangle that is not above the lowest found so far.
  unsigned not_above(const NumberedNode& node) const {
    if (!lowest_ || node.lowest == nullptr) return kAllSlots;
    unsigned slots = 0;
    for (unsigned slot = 0; slot < kMaxSlots; ++slot)
      slots |= unsigned{node.lowest[slot] <= lowest_->triangle_a} << slot;
    return slots;
  }

  Stack<Contact>& found_;
  TrianglePairs<Stack<Contact>> triangles_;
  std::optional<Contact> lowest_;
};

}  // namespace

QueryStats lowest_contact(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                          std::optional<Contact>& lowest) {
  QueryStats work;
  lowest.reset();
  scratch.found.clear();
  if (!begin_descent(a, b, work)) return work;
  const NumberedTree numbered_a = {a, a.tree, true}, numbered_b = {b, b.tree, false};
  LowestContact rule(a.tree, b.tree, scratch.found, work);
  descend_from_roots(numbered_a, numbered_b, scratch.slot_pairs, rule, work);
  lowest = rule.lowest();
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
