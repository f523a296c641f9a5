#include <pelt/inside.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <functional>
#include <utility>

namespace pelt::python {
namespace {

/// Throws an error if the surface of the poses' model is not closed.
void require_volume(const ClipPoses& poses) {
  const py::gil_scoped_release unlocked;
  if (poses.model().surface().is_closed()) return;
  throw ArgumentError(poses.name() +
                      ": the surface of the model is not closed, so it has no volume");
}

/// Values and errors [F].
using VolumeColumns = std::pair<py::array_t<double>, py::array_t<double>>;

/// Measures one body in the frames of one thread.
using Measure = std::function<void(Pose&, Scratch&, Volume&)>;

VolumeColumns measure_each(const ClipPoses& poses, const Run& run, const Measure& measure) {
  const std::size_t frames = poses.frame_count();
  VolumeColumns columns = {new_array<double>({frames}), new_array<double>({frames})};
  double *const values = columns.first.mutable_data(), *const errors =
                                                           columns.second.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    while (const auto frame = queue.next()) {
      Volume found;
      measure(pose.at(*frame), scratch, found);
      values[*frame] = found.value;
      errors[*frame] = found.error;
    }
  });
  return columns;
}

VolumeColumns all_volumes(const ClipPoses& poses, const Run& run) {
  require_volume(poses);
  return measure_each(poses, run,
                      [&](Pose& pose, Scratch&, Volume& found) { volume(pose, found); });
}

VolumeColumns all_self_volumes(const ClipPoses& poses, const Run& run) {
  require_volume(poses);
  return measure_each(poses, run, [&](Pose& pose, Scratch& scratch, Volume& found) {
    self_intersection_volume(pose, scratch, found);
  });
}

VolumeColumns all_intersection_volumes(const ClipPoses& a, const ClipPoses& b, const Run& run) {
  require_volume(a);
  require_volume(b);
  const std::size_t frames = common_frame_count(a, b);
  VolumeColumns columns = {new_array<double>({frames}), new_array<double>({frames})};
  double *const values = columns.first.mutable_data(), *const errors =
                                                           columns.second.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    while (const auto frame = queue.next()) {
      Volume found;
      intersection_volume(pose_a.at(*frame), pose_b.at(*frame), scratch, found);
      values[*frame] = found.value;
      errors[*frame] = found.error;
    }
  });
  return columns;
}

}  // namespace

void add_volume(py::module_& module) {
  module.def("volume", &all_volumes, py::arg("poses"), py::arg("run"));
  module.def("self_intersection_volume", &all_self_volumes, py::arg("poses"), py::arg("run"));
  module.def("intersection_volume", &all_intersection_volumes, py::arg("a"), py::arg("b"),
             py::arg("run"));
}

}  // namespace pelt::python
