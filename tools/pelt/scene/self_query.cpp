#include "tools/pelt/scene/self_query.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools::scene {
namespace {

using Pair = FrameContacts::Pair;

void append(std::span<const Contact> contacts, std::uint32_t a, std::uint32_t b,
            FrameContacts& to) {
  if (contacts.empty()) return;
  const std::size_t begin = to.contacts.size();
  to.contacts.insert(to.contacts.end(), contacts.begin(), contacts.end());
  to.pairs.push_back({a, b, begin, to.contacts.size()});
}

void clear(FrameContacts& contacts) {
  contacts.pairs.clear();
  contacts.contacts.clear();
}

}  // namespace

SelfQuery::SelfQuery(std::span<const Collider> colliders, SelfFilters filters,
                     std::uint32_t threads)
    : colliders_(colliders),
      filters_(std::move(filters)),
      posed_(colliders),
      workers_(std::make_unique<detail::Workers>()),
      scratches_(std::clamp<std::size_t>(detail::Workers::count_or_available(threads), 1,
                                         std::max<std::size_t>(1, colliders.size()))),
      own_(colliders.size()) {
  std::size_t instances = 0;
  for (std::size_t c = 0; c < colliders.size(); ++c) {
    if (c > 0 && colliders[c].instance != colliders[c - 1].instance) ++instances;
    filter_of_instance_.resize(colliders[c].instance + 1, instances);
    filter_of_instance_[colliders[c].instance] = instances;
  }
}

void SelfQuery::collide(const Limits& limits, FrameContacts& found) {
  left_out_ = {};
  if (!filters_.of_parts.empty()) filter_parts(limits, found);
  find(limits);
  clear(merged_);
  auto next = found.pairs.begin();
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    for (; next != found.pairs.end() && next->a < c; ++next)
      append(found.of(*next), next->a, next->b, merged_);
    append(own_[c].contacts, c, c, merged_);
  }
  for (; next != found.pairs.end(); ++next) append(found.of(*next), next->a, next->b, merged_);
  std::swap(found, merged_);
}

void SelfQuery::filter_parts(const Limits& limits, FrameContacts& found) {
  clear(merged_);
  for (const Pair& pair : found.pairs) {
    const std::span<const Contact> contacts = found.of(pair);
    kept_.assign(contacts.begin(), contacts.end());
    const std::uint32_t instance = colliders_[pair.a].instance;
    if (colliders_[pair.b].instance == instance) filter_parts_of(instance, kept_);
    kept_.resize(std::min<std::size_t>(kept_.size(), limits.max_contacts));
    append(kept_, pair.a, pair.b, merged_);
  }
  std::swap(found, merged_);
}

/// Parts are ordered by their triangles, so that the order of the triangles of a contact stays.
void SelfQuery::filter_parts_of(std::uint32_t instance, std::vector<Contact>& contacts) {
  left_out_ += leave_out(filters_.of_parts[filter_of_instance_[instance]], scratches_[0], contacts);
}

void SelfQuery::find(const Limits& limits) {
  const auto count = static_cast<std::uint32_t>(scratches_.size());
  shares_.deal(static_cast<std::uint32_t>(colliders_.size()), count);
  workers_->run(count, [&](std::uint32_t worker) {
    while (const auto c = shares_.take(worker)) find_of(*c, limits, scratches_[worker]);
  });
  for (const Own& own : own_) {
    work_ += own.stats;
    left_out_ += own.stats.left_out;
  }
}

void SelfQuery::find_of(std::uint32_t c, const Limits& limits, Scratch& scratch) {
  Own& own = own_[c];
  own.contacts.clear();
  own.stats =
      self_collide(posed_.poses()[c], filters_.of_colliders[c], scratch, own.contacts, limits);
  for (Contact& contact : own.contacts)
    contact = numbered_in_assets(contact, colliders_[c], colliders_[c]);
}

}  // namespace pelt::tools::scene
