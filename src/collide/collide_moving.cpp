#include <pelt/motion.hpp>

#include "collide/moving_trees.hpp"
#include "motion/steps.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

namespace pelt {
namespace {

MovingStats search(const Motion& a, const Motion& b, Scratch& scratch,
                   const MovingOptions& options) {
  detail::require_steps(a, b);
  const detail::Steps steps(a, b);
  return detail::collide_moving_trees(steps.a(), steps.b(), scratch.detail(), options);
}

}  // namespace

MovingStats& MovingStats::operator+=(const MovingStats& other) {
  QueryStats::operator+=(other);
  double_pairs += other.double_pairs;
  exact_pairs += other.exact_pairs;
  return *this;
}

MovingStats collide(const Motion& a, const Motion& b, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options) {
  const MovingStats stats = search(a, b, scratch, options);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(const Motion& a, const Motion& b, Scratch& scratch) {
  MovingOptions options;
  options.times = false;
  options.max_contacts = 1;
  const MovingStats stats = search(a, b, scratch, options);
  return detail::yes_or_no(!scratch.detail().moving.empty(), stats);
}

}  // namespace pelt
