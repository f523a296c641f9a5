#include "bindings/python/engine/moving_columns.hpp"

namespace pelt::python {

MovingColumns moving_columns(const FrameLists<MovingContact>& contacts) {
  const std::size_t count = contacts.size();
  MovingColumns columns = {
      new_array<std::int32_t>({count}), new_array<std::int32_t>({count}),
      new_array<std::int32_t>({count}), new_array<float>({count}),
      new_array<bool>({count}),         new_array<std::uint8_t>({count, 2, 2})};
  auto& [steps, a, b, times, at_start, features] = columns;
  contacts.for_each([&](std::size_t place, std::size_t step, const MovingContact& contact) {
    steps.mutable_data()[place] = static_cast<std::int32_t>(step);
    a.mutable_data()[place] = static_cast<std::int32_t>(contact.contact.triangle_a);
    b.mutable_data()[place] = static_cast<std::int32_t>(contact.contact.triangle_b);
    times.mutable_data()[place] = contact.time;
    at_start.mutable_data()[place] = contact.at_start;
    std::uint8_t* const feature = features.mutable_data() + 4 * place;
    feature[0] = static_cast<std::uint8_t>(contact.a.kind);
    feature[1] = contact.a.number;
    feature[2] = static_cast<std::uint8_t>(contact.b.kind);
    feature[3] = contact.b.number;
  });
  return columns;
}

}  // namespace pelt::python
