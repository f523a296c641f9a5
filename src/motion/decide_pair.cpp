#include "motion/decide_pair.hpp"

#include "motion/moving_filter.hpp"

namespace pelt::detail {

bool intersect_while_moving(const MovingTriangle& a, const MovingTriangle& b, MovingStats& work) {
  ++work.double_pairs;
  const CertainAnswer answer = certainly_intersect(a, b);
  if (answer != CertainAnswer::unknown) return answer == CertainAnswer::yes;
  ++work.exact_pairs;
  return first_meeting(a, b).has_value();
}

std::optional<FirstMeeting> find_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                               MovingStats& work) {
  ++work.double_pairs;
  std::optional<FirstMeeting> first;
  if (find_certain_first_meeting(a, b, first)) return first;
  ++work.exact_pairs;
  return first_meeting(a, b);
}

MovingContact moving_contact(const Contact& contact, const FirstMeeting& first) {
  const auto feature = [](const ClosedFeature& f) {
    return Feature{static_cast<FeatureKind>(f.kind), f.number};
  };
  if (first.at_start) return {contact, 0, true, {}, {}};
  return {contact, first.time, false, feature(first.a), feature(first.b)};
}

}  // namespace pelt::detail
