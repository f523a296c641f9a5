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

}  // namespace pelt::peers
