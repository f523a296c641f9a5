/// Descent of two trees for intersecting triangles. A node is opened when a known box overlaps its
/// bound (refit on demand, Kavan & Zara 2005, section 4.2). Opening may show that the exact boxes
/// do not overlap, so one side of a pair is opened before the other.

#include "collide/collide_trees.hpp"

#include "collide/cluster_pair.hpp"
#include "collide/pair_roots.hpp"
#include "query/contact_sink.hpp"
#include "query/pair_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters until there are enough contacts.
class IntersectingTriangles : public BoxOverlap {
 public:
  IntersectingTriangles(const Tree& a, const Tree& b, const ContactSink& sink, QueryStats& work)
      : sink_(sink), triangles_(a, b, sink.contacts(), work) {}

  bool is_full() const { return sink_.is_full(); }
  bool is_impatient() const { return sink_.is_impatient(); }

  void test(const PosedCluster& a, const PosedCluster& b) {
    triangles_.add(a, b);
    if (is_impatient()) triangles_.flush();
  }

  void flush() { triangles_.flush(); }

 private:
  const ContactSink& sink_;
  TrianglePairs triangles_;
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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
