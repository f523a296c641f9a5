#include "collide/eager.hpp"

#include "collide/collide_trees.hpp"
#include "collide/find_at_start.hpp"
#include "collide/first_contact_trees.hpp"
#include "collide/moving_trees.hpp"
#include "query/sort_contacts.hpp"

namespace pelt::detail {
namespace {

/// Views of both poses.
struct EagerStep {
  explicit EagerStep(const EagerMotion& motion)
      : from(motion.from.posed_tree()), to(motion.to.posed_tree()) {}

  MovingTree tree() const { return {from, to}; }

  PosedTree from, to;
};

}  // namespace

QueryStats collide(EagerPose& a, EagerPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const Limits& limits) {
  const QueryStats stats =
      collide_trees(a.posed_tree(), b.posed_tree(), scratch, limits.max_contacts);
  append_sorted(scratch, contacts);
  return stats;
}

MovingStats collide(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const EagerStep step_a(a), step_b(b);
  const MovingStats stats = collide_moving_trees(step_a.tree(), step_b.tree(), scratch, options);
  append_sorted(scratch, contacts);
  return stats;
}

MovingStats first_contact(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                          std::optional<MovingContact>& first) {
  const EagerStep step_a(a), step_b(b);
  MovingStats work;
  work.QueryStats::operator+=(find_at_start(step_a.from, step_b.from, scratch, first));
  if (!first) work += first_contact_of_trees(step_a.tree(), step_b.tree(), scratch, first);
  return work;
}

}  // namespace pelt::detail
