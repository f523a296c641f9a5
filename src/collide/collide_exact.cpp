#include "collide/collide_exact.hpp"

#include "collide/pair_traversal.hpp"
#include "collide/sort_contacts.hpp"

namespace pelt::detail {

QueryStats collide(ExactPose& a, ExactPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const CollideOptions& options) {
  const QueryStats stats =
      collide_trees(a.posed_tree(), b.posed_tree(), scratch, options.max_contacts);
  sort_contacts(scratch.found, scratch.sorting);
  contacts.insert(contacts.end(), scratch.found.begin(), scratch.found.end());
  return stats;
}

}  // namespace pelt::detail
