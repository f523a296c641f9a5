#include <pelt/height_field.hpp>

#include "base/wide_code.hpp"
#include "collide/sort_contacts.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"

namespace pelt {

QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                   std::vector<Contact>& contacts, const CollideOptions& options) {
  detail::Stack<Contact>& found = scratch.detail().found;
  const QueryStats stats = detail::wide_code().collide_field(
      pose.detail().posed_tree(), field.detail(), scratch.detail(), options.max_contacts);
  detail::sort_contacts(found, scratch.detail().sorting);
  contacts.insert(contacts.end(), found.begin(), found.end());
  return stats;
}

bool intersects(Pose& pose, const HeightField& field, Scratch& scratch) {
  detail::wide_code().collide_field(pose.detail().posed_tree(), field.detail(), scratch.detail(),
                                    1);
  return !scratch.detail().found.empty();
}

}  // namespace pelt
