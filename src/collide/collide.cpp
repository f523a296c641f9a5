#include <pelt/collide.hpp>

#include "base/require.hpp"
#include "collide/collide_trees.hpp"
#include "pose/pose.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

namespace pelt {

QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const Limits& limits) {
  detail::require(&a != &b, "collide: `a` and `b` are the same pose; give two poses");
  const QueryStats stats = detail::collide_trees(a.detail().posed_tree(), b.detail().posed_tree(),
                                                 scratch.detail(), limits.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(Pose& a, Pose& b, Scratch& scratch) {
  detail::require(&a != &b, "intersects: `a` and `b` are the same pose; give two poses");
  const QueryStats stats =
      detail::collide_trees(a.detail().posed_tree(), b.detail().posed_tree(), scratch.detail(), 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

}  // namespace pelt
