#include "collide/collide_exact.hpp"

#include "collide/collide_trees.hpp"
#include "query/sort_contacts.hpp"

namespace pelt::detail {

QueryStats collide(ExactPose& a, ExactPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const CollideOptions& options) {
  const QueryStats stats =
      collide_trees(a.posed_tree(), b.posed_tree(), scratch, options.max_contacts);
  append_sorted(scratch, contacts);
  return stats;
}

}  // namespace pelt::detail
