#include <pelt/collide.hpp>

#include "base/assert.hpp"
#include "collide/pair_traversal.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

namespace pelt {

QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const CollideOptions& options) {
  PELT_ASSERT(&a != &b);
  const QueryStats stats = detail::collide_trees(a.detail().posed_tree(), b.detail().posed_tree(),
                                                 scratch.detail(), options.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

bool intersects(Pose& a, Pose& b, Scratch& scratch) {
  PELT_ASSERT(&a != &b);
  detail::collide_trees(a.detail().posed_tree(), b.detail().posed_tree(), scratch.detail(), 1);
  return !scratch.detail().found.empty();
}

}  // namespace pelt
