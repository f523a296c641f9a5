#include <pelt/motion.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/moving_columns.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

namespace pelt::python {
namespace {

/// Calls `query(step, motion_a, motion_b, scratch, list)` for each step, and returns what it
/// appends.
template <class Query>
MovingColumns contacts_of_steps(const ClipPoses& a, const ClipPoses& b, const Run& run,
                                const Query& query) {
  const std::size_t steps = step_count(common_frame_count(a, b));
  FrameLists<MovingContact> found(steps);
  run_frames(
      steps, run,
      [&](FrameQueue& queue) {
        FrameMotion motion_a(a), motion_b(b);
        Scratch scratch;
        std::vector<MovingContact>& list = found.add_thread();
        while (const auto step = queue.next()) {
          const std::size_t begin = list.size();
          query(motion_a.at(*step), motion_b.at(*step), scratch, list);
          found.set(*step, list, begin);
        }
      },
      kStepsAtATime);
  return moving_columns(found);
}

using List = std::vector<MovingContact>;

MovingColumns all_moving_contacts(const ClipPoses& a, const ClipPoses& b, bool leave_out_start,
                                  bool times, std::uint32_t max_contacts, const Run& run) {
  return contacts_of_steps(
      a, b, run, [&](const Motion& from_a, const Motion& from_b, Scratch& scratch, List& list) {
        collide(from_a, from_b, scratch, list, {leave_out_start, times, max_contacts});
      });
}

/// At most one contact for each step.
MovingColumns first_contacts(const ClipPoses& a, const ClipPoses& b, bool leave_out_start,
                             const Run& run) {
  return contacts_of_steps(
      a, b, run, [&](const Motion& from_a, const Motion& from_b, Scratch& scratch, List& list) {
        std::optional<MovingContact> first;
        first_contact(from_a, from_b, scratch, first, {leave_out_start});
        if (first) list.push_back(*first);
      });
}

}  // namespace

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

void add_motion(py::module_& module) {
  module.def("collide_moving", &all_moving_contacts, py::arg("a"), py::arg("b"),
             py::arg("leave_out_start"), py::arg("times"), py::arg("max_contacts"), py::arg("run"));
  module.def("first_contact", &first_contacts, py::arg("a"), py::arg("b"),
             py::arg("leave_out_start"), py::arg("run"));
}

}  // namespace pelt::python
