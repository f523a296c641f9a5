#include <pelt/self.hpp>

#include "base/require.hpp"
#include "motion/steps.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_moving_tree.hpp"

namespace pelt {
namespace {

SelfMovingStats search(const Motion& motion, const SelfFilter& filter, Scratch& scratch,
                       const MovingOptions& options) {
  detail::require_step(motion);
  detail::require(&filter.model().detail() == &motion.from.model().detail(),
                  "self_collide: the filter is of another model");
  const detail::PosedTree from = motion.from.detail().posed_tree();
  const detail::PosedTree to = motion.to.detail().posed_tree();
  return detail::self_collide_moving_tree({from, to}, filter.detail(), scratch.detail(), options);
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
  MovingOptions options;
  options.times = false;
  options.max_contacts = 1;
  const SelfMovingStats stats = search(motion, filter, scratch, options);
  return detail::yes_or_no(!scratch.detail().moving.empty(), stats);
}

}  // namespace pelt
