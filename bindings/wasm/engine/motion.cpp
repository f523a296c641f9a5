/// Queries of steps from one pose to the next. Each motion is passed as two poses of one body.

#include <pelt/motion.hpp>
#include <pelt/self.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/moving_columns.hpp"

#include <span>

namespace pelt::wasm {
namespace {

std::vector<MovingContact>& found() {
  static std::vector<MovingContact> found;
  return found;
}

void answer_moving_stats(const MovingStats& stats) {
  answer_stats(stats);
  answer().double_pairs = static_cast<double>(stats.double_pairs);
  answer().exact_pairs = static_cast<double>(stats.exact_pairs);
}

/// Answers with pairs of the characters' triangle numbers. JavaScript reads the rest with
/// pelt_moving_column.
void answer_contacts(std::span<const MovingContact> contacts, bool has_times, const Body& a,
                     const Body& b) {
  static std::vector<Contact> pairs;
  pairs.clear();
  clear_moving_columns();
  for (const MovingContact& moving : contacts) {
    const auto& [triangle_a, triangle_b] = moving.contact;
    pairs.push_back({triangle_a + a.first_triangle, triangle_b + b.first_triangle});
    if (has_times) add_to_moving_columns(moving);
  }
  answer_data<Contact>(pairs);
}

}  // namespace

/// Precondition, also of the next functions: both poses of a motion are of one body, and no pose is
/// in both motions.
PELT_EXPORT void pelt_collide_moving(PoseHandle* a, PoseHandle* a_to, PoseHandle* b,
                                     PoseHandle* b_to, std::uint32_t leaves_out_start,
                                     std::uint32_t has_times, std::uint32_t most) {
  found().clear();
  const MovingOptions options = {leaves_out_start != 0, has_times != 0, most};
  answer_moving_stats(
      collide({a->pose, a_to->pose}, {b->pose, b_to->pose}, scratch(), found(), options));
  answer_contacts(found(), options.times, a->body, b->body);
}

PELT_EXPORT std::uint32_t pelt_touch_while_moving(PoseHandle* a, PoseHandle* a_to, PoseHandle* b,
                                                  PoseHandle* b_to) {
  return answer_yes_no(intersects({a->pose, a_to->pose}, {b->pose, b_to->pose}, scratch()));
}

/// Returns whether there is any contact, and answers with it.
PELT_EXPORT std::uint32_t pelt_first_contact(PoseHandle* a, PoseHandle* a_to, PoseHandle* b,
                                             PoseHandle* b_to, std::uint32_t leaves_out_start) {
  std::optional<MovingContact> first;
  answer_moving_stats(first_contact({a->pose, a_to->pose}, {b->pose, b_to->pose}, scratch(), first,
                                    {leaves_out_start != 0}));
  if (!first) return 0;
  answer_contacts({&*first, 1}, true, a->body, b->body);
  return 1;
}

/// Precondition, also of the next function: the filter is of the body of the poses.
PELT_EXPORT void pelt_self_collide_moving(PoseHandle* from, PoseHandle* to,
                                          const FilterHandle* filter,
                                          std::uint32_t leaves_out_start, std::uint32_t has_times,
                                          std::uint32_t most) {
  found().clear();
  const MovingOptions options = {leaves_out_start != 0, has_times != 0, most};
  const SelfMovingStats stats =
      self_collide({from->pose, to->pose}, filter->filter, scratch(), found(), options);
  answer_moving_stats(stats);
  answer_left_out(stats.left_out);
  answer_contacts(found(), options.times, from->body, from->body);
}

PELT_EXPORT std::uint32_t pelt_self_touches_while_moving(PoseHandle* from, PoseHandle* to,
                                                         const FilterHandle* filter) {
  return answer_yes_no(self_intersects({from->pose, to->pose}, filter->filter, scratch()));
}

}  // namespace pelt::wasm
