/// Queries of steps from one pose to the next. Each motion is passed as two poses of one body.

#include <pelt/motion.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

#include <span>

namespace pelt::wasm {
namespace {

std::vector<MovingContact>& found() {
  static std::vector<MovingContact> found;
  return found;
}

/// Arrays that JavaScript reads one by one. Same order as in motion.mjs.
enum class MovingColumn : std::uint32_t { pairs, times, at_start, features };

/// Returned arrays, valid until the next call.
struct MovingColumns {
  std::vector<Contact> pairs;
  std::vector<float> times;
  std::vector<std::uint8_t> at_start;
  std::vector<std::uint8_t> features;  // [N][4] kind and number of a, then of b
};

MovingColumns& columns() {
  static MovingColumns columns;
  return columns;
}

void answer_moving_stats(const MovingStats& stats) {
  answer_stats(stats);
  answer().double_pairs = static_cast<double>(stats.double_pairs);
  answer().exact_pairs = static_cast<double>(stats.exact_pairs);
}

/// Converts to the characters' triangle numbers. Writes zeros for what has no meaning.
void write_columns(std::span<const MovingContact> contacts, bool has_times, const PoseHandle& a,
                   const PoseHandle& b) {
  columns() = {};
  for (const MovingContact& moving : contacts) {
    const auto& [contact, time, at_start, of_a, of_b] = moving;
    columns().pairs.push_back(
        {contact.triangle_a + a.body.first_triangle, contact.triangle_b + b.body.first_triangle});
    if (!has_times) continue;
    columns().times.push_back(time);
    columns().at_start.push_back(at_start ? 1 : 0);
    for (const Feature& feature : {of_a, of_b}) {
      columns().features.push_back(at_start ? 0 : static_cast<std::uint8_t>(feature.kind));
      columns().features.push_back(at_start ? 0 : feature.number);
    }
  }
}

}  // namespace

/// Read the contacts with pelt_moving_column. Precondition, also of the next functions: both poses
/// of a motion are of one body, and no pose is in both motions.
PELT_EXPORT void pelt_collide_moving(PoseHandle* a, PoseHandle* a_to, PoseHandle* b,
                                     PoseHandle* b_to, std::uint32_t leaves_out_start,
                                     std::uint32_t has_times, std::uint32_t most) {
  found().clear();
  const MovingOptions options = {leaves_out_start != 0, has_times != 0, most};
  answer_moving_stats(
      collide_moving({a->pose, a_to->pose}, {b->pose, b_to->pose}, scratch(), found(), options));
  write_columns(found(), options.times, *a, *b);
}

PELT_EXPORT std::uint32_t pelt_touch_while_moving(PoseHandle* a, PoseHandle* a_to, PoseHandle* b,
                                                  PoseHandle* b_to) {
  return answer_yes_no(touch_while_moving({a->pose, a_to->pose}, {b->pose, b_to->pose}, scratch()));
}

/// Returns whether there is any contact. Read it with pelt_moving_column.
PELT_EXPORT std::uint32_t pelt_first_contact(PoseHandle* a, PoseHandle* a_to, PoseHandle* b,
                                             PoseHandle* b_to, std::uint32_t leaves_out_start) {
  std::optional<MovingContact> first;
  answer_moving_stats(first_contact({a->pose, a_to->pose}, {b->pose, b_to->pose}, scratch(), first,
                                    {leaves_out_start != 0}));
  if (!first) return 0;
  write_columns({&*first, 1}, true, *a, *b);
  return 1;
}

PELT_EXPORT void pelt_moving_column(MovingColumn column) {
  switch (column) {
    case MovingColumn::pairs:
      return answer_data<Contact>(columns().pairs);
    case MovingColumn::times:
      return answer_data<float>(columns().times);
    case MovingColumn::at_start:
      return answer_data<std::uint8_t>(columns().at_start);
    case MovingColumn::features:
      return answer_data<std::uint8_t>(columns().features);
  }
}

}  // namespace pelt::wasm
