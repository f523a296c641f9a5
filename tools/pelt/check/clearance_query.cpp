#include "tools/pelt/check/clearance_query.hpp"

namespace pelt::tools::check {

void ClearanceQuery::collide(const Limits& limits, scene::FrameContacts& found) {
  found.pairs.clear();
  found.contacts.clear();
  const std::span<Pose> poses = posed_.poses();
  for (const auto& [a, b] : near_pairs_.find(poses, tolerance_)) {
    const std::size_t begin = found.contacts.size();
    near_.clear();
    work_ += clearance(poses[a], poses[b], tolerance_, scratch_, near_, {limits.max_contacts});
    for (const Contact& pair : near_)
      found.contacts.push_back(scene::numbered_in_assets(pair, colliders_[a], colliders_[b]));
    const std::size_t end = found.contacts.size();
    if (end > begin) found.pairs.push_back({a, b, begin, end});
  }
}

}  // namespace pelt::tools::check
