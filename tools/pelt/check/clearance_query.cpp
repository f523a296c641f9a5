#include "tools/pelt/check/clearance_query.hpp"

namespace pelt::tools::check {

void ClearanceQuery::collide(const CollideOptions& options, scene::FrameContacts& found) {
  found.pairs.clear();
  found.contacts.clear();
  const std::span<Pose> poses = posed_.poses();
  for (std::uint32_t a = 0; a < poses.size(); ++a) {
    for (std::uint32_t b = a + 1; b < poses.size(); ++b) {
      const std::size_t begin = found.contacts.size();
      work_ += clearance(poses[a], poses[b], tolerance_, scratch_, found.contacts,
                         {options.max_contacts});
      const std::size_t end = found.contacts.size();
      for (Contact& contact : std::span(found.contacts).subspan(begin)) {
        contact.triangle_a += colliders_[a].first_triangle;
        contact.triangle_b += colliders_[b].first_triangle;
      }
      if (end > begin) found.pairs.push_back({a, b, begin, end});
    }
  }
}

}  // namespace pelt::tools::check
