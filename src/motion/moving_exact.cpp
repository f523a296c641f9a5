#include "motion/moving_exact.hpp"

#include "motion/find_at_start.hpp"
#include "motion/first_contact_trees.hpp"
#include "motion/moving_trees.hpp"
#include "query/sort_contacts.hpp"

namespace pelt::detail {
namespace {

/// Views of both poses.
struct ExactStep {
  explicit ExactStep(const ExactMotion& motion)
      : from(motion.from.posed_tree()), to(motion.to.posed_tree()) {}

  MovingTree tree() const { return {from, to}; }

  PosedTree from, to;
};

}  // namespace

MovingStats collide_moving(const ExactMotion& a, const ExactMotion& b, Scratch& scratch,
                           std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const ExactStep step_a(a), step_b(b);
  const MovingStats stats = collide_moving_trees(step_a.tree(), step_b.tree(), scratch, options);
  append_sorted(scratch, contacts);
  return stats;
}

MovingStats first_contact(const ExactMotion& a, const ExactMotion& b, Scratch& scratch,
                          std::optional<MovingContact>& first) {
  const ExactStep step_a(a), step_b(b);
  MovingStats work;
  work.QueryStats::operator+=(find_at_start(step_a.from, step_b.from, scratch, first));
  if (!first) work += first_contact_of_trees(step_a.tree(), step_b.tree(), scratch, first);
  return work;
}

}  // namespace pelt::detail
