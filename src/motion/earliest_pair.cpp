#include "motion/earliest_pair.hpp"

#include "motion/decide_pair.hpp"

#include <cmath>

namespace pelt::detail {

void EarliestPair::add(const Contact& contact, const MovingTriangle& a, const MovingTriangle& b,
                       MovingStats& work) {
  const std::optional<FirstMeeting> first = find_first_meeting(a, b, work);
  if (first && !first->at_start) add(contact, {a, b, *first});
}

bool EarliestPair::add(const Contact& contact, const MeetingPair& pair) {
  std::optional<int> order = pair_ ? certain_order(pair, *pair_) : -1;
  const bool is_certain = order.has_value();
  if (!is_certain) order = compare_first_times(pair, *pair_);
  if (*order < 0 || (*order == 0 && contact < contact_)) {
    contact_ = contact;
    pair_ = pair;
  }
  return is_certain;
}

float EarliestPair::latest() const { return pair_ ? std::nextafter(pair_->first.time, 2.0f) : 1; }

std::optional<MovingContact> EarliestPair::contact() const {
  if (!pair_) return std::nullopt;
  return moving_contact(contact_, pair_->first);
}

}  // namespace pelt::detail
