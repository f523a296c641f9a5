/// Queries of steps from one pose to the next. Each motion is passed as two poses of one body.

#include <pelt/self.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/moving_columns.hpp"

namespace pelt::wasm {
namespace {

std::vector<MovingContact>& found_moving() {
  static std::vector<MovingContact> found;
  found.clear();
  return found;
}

/// Answers with pairs of the characters' triangle numbers, then with times and features.
void answer_moving(std::span<const MovingContact> contacts, bool has_times, const Body& a,
                   const Body& b) {
  static std::vector<Contact> pairs;
  static MovingColumns columns;
  pairs.clear();
  columns = {};
  for (const MovingContact& moving : contacts) {
    const auto& [triangle_a, triangle_b] = moving.contact;
    pairs.push_back({triangle_a + a.first_triangle, triangle_b + b.first_triangle});
    if (has_times) columns.add(moving);
  }
  answer_arrays(pairs, columns.times, columns.at_start, columns.features);
}

}  // namespace

void MovingColumns::add(const MovingContact& moving) {
  times.push_back(moving.time);
  at_start.push_back(moving.at_start ? 1 : 0);
  for (const Feature& feature : {moving.a, moving.b}) {
    features.push_back(moving.at_start ? 0 : static_cast<std::uint8_t>(feature.kind));
    features.push_back(moving.at_start ? 0 : feature.number);
  }
}

/// Precondition, also of the next functions: both poses of a motion are of one body, and no pose is
/// in both motions.
MovingStats collide_moving(PoseHandle& a, PoseHandle& a_to, PoseHandle& b, PoseHandle& b_to,
                           bool leaves_out_start, bool has_times, std::uint32_t most) {
  std::vector<MovingContact>& found = found_moving();
  const MovingStats stats = pelt::collide({a.pose, a_to.pose}, {b.pose, b_to.pose}, scratch(),
                                          found, {leaves_out_start, has_times, most});
  answer_moving(found, has_times, a.body, b.body);
  return stats;
}
PELT_EXPORT(collide_moving)

YesNo touch_while_moving(PoseHandle& a, PoseHandle& a_to, PoseHandle& b, PoseHandle& b_to) {
  return pelt::intersects({a.pose, a_to.pose}, {b.pose, b_to.pose}, scratch());
}
PELT_EXPORT(touch_while_moving)

/// Returns whether there is any contact, and answers with it.
bool first_contact(PoseHandle& a, PoseHandle& a_to, PoseHandle& b, PoseHandle& b_to,
                   bool leaves_out_start) {
  std::optional<MovingContact> first;
  answer_stats(pelt::first_contact({a.pose, a_to.pose}, {b.pose, b_to.pose}, scratch(), first,
                                   {leaves_out_start}));
  if (first) answer_moving({&*first, 1}, true, a.body, b.body);
  return first.has_value();
}
PELT_EXPORT(first_contact)

/// Precondition, also of the next function: the filter is of the body of the poses.
SelfMovingStats self_collide_moving(PoseHandle& from, PoseHandle& to, const FilterHandle& filter,
                                    bool leaves_out_start, bool has_times, std::uint32_t most) {
  std::vector<MovingContact>& found = found_moving();
  const SelfMovingStats stats = pelt::self_collide({from.pose, to.pose}, filter.filter, scratch(),
                                                   found, {leaves_out_start, has_times, most});
  answer_moving(found, has_times, from.body, from.body);
  return stats;
}
PELT_EXPORT(self_collide_moving)

YesNo self_touches_while_moving(PoseHandle& from, PoseHandle& to, const FilterHandle& filter) {
  return pelt::self_intersects({from.pose, to.pose}, filter.filter, scratch());
}
PELT_EXPORT(self_touches_while_moving)

}  // namespace pelt::wasm
