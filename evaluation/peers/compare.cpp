#include "evaluation/peers/compare.hpp"

#include <algorithm>
#include <vector>

namespace pelt::peers {

namespace {

std::vector<Contact> as_set(std::span<const Contact> contacts) {
  std::vector<Contact> set(contacts.begin(), contacts.end());
  std::sort(set.begin(), set.end());
  set.erase(std::unique(set.begin(), set.end()), set.end());
  return set;
}

/// Number of contacts of `a` that `b` does not contain. Precondition: both are sets.
std::size_t count_only_in(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&](const Contact& contact) {
    return !std::binary_search(b.begin(), b.end(), contact);
  }));
}

}  // namespace

Difference& Difference::operator+=(const Difference& other) {
  missing += other.missing;
  extra += other.extra;
  repeated += other.repeated;
  return *this;
}

Difference compare(std::span<const Contact> answer, std::span<const Contact> exact) {
  const std::vector<Contact> ours = as_set(answer), theirs = as_set(exact);
  return {count_only_in(theirs, ours), count_only_in(ours, theirs), answer.size() - ours.size()};
}

namespace {

/// The contact of these triangles, or null.
const MovingContact* find(std::span<const MovingContact> contacts, const Contact& contact) {
  const auto place = std::lower_bound(
      contacts.begin(), contacts.end(), contact,
      [](const MovingContact& moving, const Contact& key) { return moving.contact < key; });
  return place != contacts.end() && place->contact == contact ? &*place : nullptr;
}

}  // namespace

MovingDifference& MovingDifference::operator+=(const MovingDifference& other) {
  missing_at_start += other.missing_at_start;
  missing_later += other.missing_later;
  extra += other.extra;
  early += other.early;
  late += other.late;
  return *this;
}

MovingDifference compare_moving(std::span<const MovingContact> answer,
                                std::span<const MovingContact> exact) {
  MovingDifference difference;
  for (const MovingContact& contact : answer)
    difference.extra += find(exact, contact.contact) == nullptr;
  for (const MovingContact& contact : exact) {
    const MovingContact* const found = find(answer, contact.contact);
    if (found == nullptr) {
      ++(contact.at_start ? difference.missing_at_start : difference.missing_later);
    } else if (!contact.at_start) {
      difference.early += found->time < contact.time - kTimeTolerance;
      difference.late += found->time > contact.time + kTimeTolerance;
    }
  }
  return difference;
}

}  // namespace pelt::peers
