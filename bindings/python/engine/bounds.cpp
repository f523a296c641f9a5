#include <pelt/bounds.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <tuple>

namespace pelt::python {
namespace {

/// Low [F, 3] and high [F, 3] of the boxes, centre [F, 3] and radius [F] of the spheres.
using BoundsColumns =
    std::tuple<py::array_t<float>, py::array_t<float>, py::array_t<float>, py::array_t<float>>;

BoundsColumns all_bounds(const ClipPoses& poses, bool exact, std::uint32_t levels, const Run& run) {
  const std::size_t frames = poses.frame_count();
  BoundsColumns columns = {new_array<float>({frames, 3}), new_array<float>({frames, 3}),
                           new_array<float>({frames, 3}), new_array<float>({frames})};
  auto& [lows, highs, centres, radii] = columns;
  float *const low = lows.mutable_data(), *const high = highs.mutable_data(),
               *const centre = centres.mutable_data(), *const radius = radii.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    while (const auto frame = queue.next()) {
      Bounds found;
      if (exact)
        exact_bounds(pose.at(*frame), found);
      else
        bounds(pose.at(*frame), found, levels);
      SurfacePointColumns::set_vector(low, *frame, found.box.low);
      SurfacePointColumns::set_vector(high, *frame, found.box.high);
      SurfacePointColumns::set_vector(centre, *frame, found.sphere.centre);
      radius[*frame] = found.sphere.radius;
    }
  });
  return columns;
}

}  // namespace

void add_bounds(py::module_& module) {
  module.def("bounds", &all_bounds, py::arg("poses"), py::arg("exact"), py::arg("levels"),
             py::arg("run"));
}

}  // namespace pelt::python
