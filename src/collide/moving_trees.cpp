/// Descent of two moving trees for triangles that intersect at some time of a step. Nodes are
/// tested by their boxes at both ends (moving_boxes.hpp), so common motion cancels.

#include "collide/moving_trees.hpp"

#include "motion/moving_overlap.hpp"
#include "motion/moving_pairs.hpp"
#include "motion/moving_roots.hpp"
#include "motion/moving_triangles.hpp"
#include "query/contact_sink.hpp"
#include "query/pair_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters until there are enough contacts.
class IntersectingWhileMoving : public MovingOverlap {
 public:
  IntersectingWhileMoving(const Tree& a, const Tree& b, const LimitedSink<MovingContact>& sink,
                          const MovingOptions& options, MovingStats& work)
      : sink_(sink), pairs_(a, b), triangles_(pairs_, sink.contacts(), options, work) {}

  bool is_full() const { return sink_.is_full(); }
  bool is_impatient() const { return sink_.is_impatient(); }

  void test(const MovingCluster& a, const MovingCluster& b) {
    pairs_.add(a, b, OverlapUntil{latest()}, [this] { flush(); });
    if (is_impatient()) flush();
  }

  void flush() { triangles_.flush(); }

 private:
  const LimitedSink<MovingContact>& sink_;
  MovingPairs pairs_;
  MovingTriangles<MovingPairs> triangles_;
};

}  // namespace

MovingStats collide_moving_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                 const MovingOptions& options) {
  MovingStats work;
  scratch.moving.clear();
  if (!begin_descent(a, b, work)) return work;
  const LimitedSink sink(scratch.moving, options.max_contacts);
  IntersectingWhileMoving rule(a.tree, b.tree, sink, options, work);
  const bool is_unfinished = descend_from_roots(a, b, scratch.slot_pairs, rule, work);
  rule.flush();
  work.cut_short = sink.cut(is_unfinished);
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
