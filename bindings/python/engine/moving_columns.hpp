#pragma once

/// Contacts of steps as NumPy arrays.

#include <pelt/motion.hpp>

#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/frame_lists.hpp"

#include <cstdint>
#include <tuple>

namespace pelt::python {

/// Steps that one thread gets at a time: the end of a step is the start of the next.
inline constexpr std::size_t kStepsAtATime = 4;

/// The columns step, triangle_a, triangle_b, time, at_start [N], and features [N, 2, 2]: kind and
/// number of that of a and that of b.
using MovingColumns =
    std::tuple<py::array_t<std::int32_t>, py::array_t<std::int32_t>, py::array_t<std::int32_t>,
               py::array_t<float>, py::array_t<bool>, py::array_t<std::uint8_t>>;

MovingColumns moving_columns(const FrameLists<MovingContact>& contacts);

}  // namespace pelt::python
