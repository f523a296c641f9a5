#include "motion/earliest_pair.hpp"

#include "motion/decide_pair.hpp"

#include <cmath>

namespace pelt::detail {

void EarliestPair::add(const Contact& contact, const MovingTriangle& a, const MovingTriangle& b,
                       MovingStats& work) {
  const std::optional<FirstMeeting> first = find_first_meeting(a, b, work);
  if (!first || first->at_start) return;
  const MeetingPair pair = {a, b, *first};
  if (pair_ && !is_earlier(contact, pair)) return;
  contact_ = contact;
  pair_ = pair;
}

bool EarliestPair::is_earlier(const Contact& contact, const MeetingPair& pair) const {
  const int order = compare_first_times(pair, *pair_);
  return order < 0 || (order == 0 && contact < contact_);
}

float EarliestPair::latest() const { return pair_ ? std::nextafter(pair_->first.time, 2.0f) : 1; }

std::optional<MovingContact> EarliestPair::contact() const {
  if (!pair_) return std::nullopt;
  return moving_contact(contact_, pair_->first);
}

}  // namespace pelt::detail
