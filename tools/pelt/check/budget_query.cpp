#include "tools/pelt/check/budget_query.hpp"

#include <algorithm>

namespace pelt::tools::check {

void BudgetQuery::collide(const Limits&, scene::FrameContacts& found) {
  found.pairs.clear();
  found.contacts.clear();
  undecided_.clear();
  const std::span<Pose> poses = posed_.poses();
  for (const auto& [a, b] : near_pairs_.find(poses, 0)) {
    CollisionSearch search(poses[a], poses[b], SearchOrder::resolution);
    work_ += search.advance(budget_, scratch_);
    if (!search.is_complete())
      undecided_.push_back({a, b, search.verdict(), search.undecided_pairs(), search.resolution(),
                            search.distance_bound()});
    contacts_.assign(search.contacts().begin(), search.contacts().end());
    std::sort(contacts_.begin(), contacts_.end());
    const std::size_t begin = found.contacts.size();
    for (const Contact& contact : contacts_)
      found.contacts.push_back(scene::numbered_in_assets(contact, colliders_[a], colliders_[b]));
    const std::size_t end = found.contacts.size();
    if (end > begin) found.pairs.push_back({a, b, begin, end});
  }
  work_.cut_short = false;  // the answer says what is undecided
}

}  // namespace pelt::tools::check
