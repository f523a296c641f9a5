#include <pelt/solid.hpp>

#include "motion/moving_tree.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "solid/moving_descent.hpp"
#include "solid/prepared_region.hpp"

namespace pelt {
namespace {

/// Writes the triangles to `scratch`, in no particular order.
MovingStats find_moving(const Motion& motion, const Region& region, Scratch& scratch,
                        const MovingOptions& options) {
  const detail::Step step = detail::step_of(motion);
  const detail::PreparedRegion prepared(region);
  return prepared.is_capsule ? detail::descend_moving_in_capsule(step.tree(), prepared.capsule,
                                                                 scratch.detail(), options)
                             : detail::descend_moving_in_faces(step.tree(), prepared.faces,
                                                               scratch.detail(), options);
}

}  // namespace

MovingStats collide(const Motion& motion, const Region& region, Scratch& scratch,
                    std::vector<RegionEntry>& entries, const MovingOptions& options) {
  const MovingStats stats = find_moving(motion, region, scratch, options);
  detail::Stack<MovingContact>& found = scratch.detail().moving;
  detail::sort_contacts(found, scratch.detail().sorting_moving);
  detail::reserve_more(entries, found.size());
  for (const MovingContact& c : found)
    entries.push_back({c.contact.triangle_a, c.time, c.at_start});
  return stats;
}

YesNo intersects(const Motion& motion, const Region& region, Scratch& scratch) {
  return detail::touches_while_moving(scratch.detail(), [&](const MovingOptions& options) {
    return find_moving(motion, region, scratch, options);
  });
}

}  // namespace pelt
