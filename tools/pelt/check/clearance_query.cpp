#include "tools/pelt/check/clearance_query.hpp"

namespace pelt::tools::check {

void ClearanceQuery::collide(const CollideOptions& options, scene::FrameContacts& found) {
  found.pairs.clear();
  found.contacts.clear();
  const std::span<Pose> poses = posed_.poses();
  for (const auto& [a, b] : near_pairs_.find(poses, tolerance_)) {
    const std::size_t begin = found.contacts.size();
    work_ +=
        clearance(poses[a], poses[b], tolerance_, scratch_, found.contacts, {options.max_contacts});
    const std::size_t end = found.contacts.size();
    for (Contact& contact : std::span(found.contacts).subspan(begin))
      contact = scene::numbered_in_assets(contact, colliders_[a], colliders_[b]);
    if (end > begin) found.pairs.push_back({a, b, begin, end});
  }
}

}  // namespace pelt::tools::check
