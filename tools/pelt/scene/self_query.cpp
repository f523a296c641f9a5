#include "tools/pelt/scene/self_query.hpp"

#include <utility>

namespace pelt::tools::scene {
namespace {

using Pair = FrameContacts::Pair;

void append(const FrameContacts& from, const Pair& pair, FrameContacts& to) {
  const std::span<const Contact> contacts = from.of(pair);
  const std::size_t begin = to.contacts.size();
  to.contacts.insert(to.contacts.end(), contacts.begin(), contacts.end());
  to.pairs.push_back({pair.a, pair.b, begin, to.contacts.size()});
}

/// Merges two lists of pairs, both ascending.
void merge(const FrameContacts& x, const FrameContacts& y, FrameContacts& merged) {
  merged.pairs.clear();
  merged.contacts.clear();
  const auto is_before = [](const Pair& p, const Pair& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  };
  auto next = y.pairs.begin();
  for (const Pair& pair : x.pairs) {
    while (next != y.pairs.end() && is_before(*next, pair)) append(y, *next++, merged);
    append(x, pair, merged);
  }
  while (next != y.pairs.end()) append(y, *next++, merged);
}

}  // namespace

void SelfQuery::collide(const CollideOptions& options, FrameContacts& found) {
  find(options);
  if (own_.pairs.empty()) return;
  merge(found, own_, merged_);
  std::swap(found, merged_);
}

void SelfQuery::find(const CollideOptions& options) {
  own_.pairs.clear();
  own_.contacts.clear();
  left_out_ = {};
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    const std::size_t begin = own_.contacts.size();
    const SelfStats stats =
        self_collide(posed_.poses()[c], filters_[c], scratch_, own_.contacts, options);
    work_ += stats;
    left_out_ += stats.left_out;
    const std::size_t end = own_.contacts.size();
    for (std::size_t i = begin; i < end; ++i)
      own_.contacts[i] = numbered_in_assets(own_.contacts[i], colliders_[c], colliders_[c]);
    if (end > begin) own_.pairs.push_back({c, c, begin, end});
  }
}

}  // namespace pelt::tools::scene
