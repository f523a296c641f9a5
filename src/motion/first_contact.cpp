#include <pelt/motion.hpp>

#include "collide/collide_trees.hpp"
#include "motion/first_contact_trees.hpp"
#include "motion/steps.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"

#include <algorithm>

namespace pelt {
namespace {

/// Sets `first` to the lowest pair of triangles that intersect at time 0. If there is none, `first`
/// is empty.
QueryStats find_at_start(const Motion& a, const Motion& b, Scratch& scratch,
                         std::optional<MovingContact>& first) {
  const QueryStats work =
      detail::collide_trees(a.from.detail().posed_tree(), b.from.detail().posed_tree(),
                            scratch.detail(), std::numeric_limits<std::uint32_t>::max());
  auto& found = scratch.detail().found;
  first.reset();
  if (!found.empty()) first = {*std::min_element(found.begin(), found.end()), 0, true, {}, {}};
  return work;
}

}  // namespace

MovingStats first_contact(const Motion& a, const Motion& b, Scratch& scratch,
                          std::optional<MovingContact>& first, const FirstContactOptions& options) {
  detail::require_steps(a, b);
  MovingStats work;
  if (!options.leave_out_start) {
    work.QueryStats::operator+=(find_at_start(a, b, scratch, first));
    if (first) return work;
  }
  const detail::Steps steps(a, b);
  work += detail::first_contact_of_trees(steps.a(), steps.b(), scratch.detail(), first);
  return work;
}

}  // namespace pelt
