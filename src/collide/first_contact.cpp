#include <pelt/motion.hpp>

#include "collide/find_at_start.hpp"
#include "collide/first_contact_trees.hpp"
#include "motion/steps.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"

namespace pelt {

MovingStats first_contact(const Motion& a, const Motion& b, Scratch& scratch,
                          std::optional<MovingContact>& first, const MovingOptions& options) {
  detail::require_steps(a, b);
  MovingStats work;
  if (!options.leave_out_start) {
    work.QueryStats::operator+=(detail::find_at_start(
        a.from.detail().posed_tree(), b.from.detail().posed_tree(), scratch.detail(), first));
    if (first) return work;
  }
  const detail::Steps steps(a, b);
  work += detail::first_contact_of_trees(steps.a(), steps.b(), scratch.detail(), first);
  return work;
}

}  // namespace pelt
