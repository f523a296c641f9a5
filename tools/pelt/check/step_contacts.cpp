#include "tools/pelt/check/step_contacts.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools::check {
namespace {

/// Whether the contacts of a frame contain this one. O(log n) in pairs and contacts.
bool contains(const scene::FrameContacts& found, const FoundInStep& touch) {
  const auto pair = std::lower_bound(
      found.pairs.begin(), found.pairs.end(), std::pair(touch.a, touch.b),
      [](const scene::FrameContacts::Pair& p, const std::pair<std::uint32_t, std::uint32_t>& key) {
        return std::pair(p.a, p.b) < key;
      });
  if (pair == found.pairs.end() || pair->a != touch.a || pair->b != touch.b) return false;
  const std::span<const Contact> contacts = found.of(*pair);
  return std::binary_search(contacts.begin(), contacts.end(), touch.contact);
}

/// Appends a contact. Pairs of colliders ascend.
void append(const FoundInStep& touch, scene::FrameContacts& contacts) {
  const std::size_t end = contacts.contacts.size();
  if (contacts.pairs.empty() || contacts.pairs.back().a != touch.a ||
      contacts.pairs.back().b != touch.b)
    contacts.pairs.push_back({touch.a, touch.b, end, end});
  contacts.pairs.back().end = end + 1;
  contacts.contacts.push_back(touch.contact);
}

}  // namespace

std::size_t StepContacts::earliest() const {
  const auto first = std::min_element(
      firsts.begin(), firsts.end(),
      [](const FirstTouch& x, const FirstTouch& y) { return x.seconds < y.seconds; });
  return static_cast<std::size_t>(first - firsts.begin());
}

StepContacts contacts_of_step(const StepAnswer& step, const scene::FrameContacts& at_start,
                              const scene::FrameContacts& at_end) {
  StepContacts contacts;
  contacts.from = step.from;
  contacts.to = step.to;
  contacts.contacts = at_start.contacts.size();
  for (const FoundInStep& touch : step.found) {
    if (contains(at_start, touch)) continue;
    ++contacts.contacts;
    if (contains(at_end, touch)) continue;
    append(touch, contacts.between);
    contacts.firsts.push_back(touch.first);
  }
  return contacts;
}

}  // namespace pelt::tools::check
