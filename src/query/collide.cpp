#include <pelt/collide.hpp>

#include "base/assert.hpp"
#include "base/scratch.hpp"
#include "pose/pose.hpp"

#include <algorithm>

namespace pelt {

QueryStats& QueryStats::operator+=(const QueryStats& other) {
  node_pairs += other.node_pairs;
  refits += other.refits;
  posed_vertices += other.posed_vertices;
  triangle_pairs += other.triangle_pairs;
  cut_short = cut_short || other.cut_short;
  return *this;
}

Scratch::Scratch() : scratch_(std::make_unique<detail::Scratch>()) {}
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;
Scratch::~Scratch() = default;

QueryStats collide(Pose& a, Pose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const CollideOptions& options) {
  PELT_ASSERT(&a != &b);
  const auto first = static_cast<std::ptrdiff_t>(contacts.size());
  const QueryStats stats = detail::engine_collide(a.detail().side(), b.detail().side(),
                                                  scratch.detail(), contacts, options.max_contacts);
  std::sort(contacts.begin() + first, contacts.end());
  return stats;
}

bool intersects(Pose& a, Pose& b, Scratch& scratch) {
  std::vector<Contact>& contacts = scratch.detail().contacts;
  contacts.clear();
  collide(a, b, scratch, contacts, {.max_contacts = 1});
  return !contacts.empty();
}

}  // namespace pelt
