#include "evaluation/peers/moving_compare.hpp"

#include <algorithm>

namespace pelt::peers {
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
