#include <pelt/self.hpp>

#include "base/require.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_moving_tree.hpp"

namespace pelt {
namespace {

SelfMovingStats search(const Motion& motion, const SelfFilter& filter, Scratch& scratch,
                       const MovingOptions& options) {
  const detail::Step step = detail::step_of(motion);
  detail::require(&filter.model().detail() == &motion.from.model().detail(),
                  "self_collide: the filter is of another model");
  return detail::self_collide_moving_tree(step.tree(), filter.detail(), scratch.detail(), options);
}

}  // namespace

SelfMovingStats& SelfMovingStats::operator+=(const SelfMovingStats& other) {
  MovingStats::operator+=(other);
  left_out += other.left_out;
  return *this;
}

SelfMovingStats self_collide(const Motion& motion, const SelfFilter& filter, Scratch& scratch,
                             std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const SelfMovingStats stats = search(motion, filter, scratch, options);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo self_intersects(const Motion& motion, const SelfFilter& filter, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return search(motion, filter, scratch, options);
  });
}

}  // namespace pelt
