#include <pelt/pose.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

namespace pelt::python {
namespace {

/// Returns the posed vertices [F, V, 3].
py::array_t<float> all_posed_vertices(const ClipPoses& poses, const Run& run) {
  const std::size_t frames = poses.frame_count(), vertices = poses.model().vertex_count();
  py::array_t<float> result = new_array<float>({frames, vertices, 3});
  Vec3* const out = reinterpret_cast<Vec3*>(result.mutable_data());
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    while (const auto frame = queue.next())
      posed_vertices(pose.at(*frame), std::span(out + *frame * vertices, vertices));
  });
  return result;
}

}  // namespace

void add_poses(py::module_& module) {
  py::class_<Run>(module, "Run")
      .def(py::init<std::uint32_t, py::object>(), py::arg("threads"), py::arg("on_progress"));
  py::class_<ClipPoses>(module, "ClipPoses")
      .def_static("of_palettes", &ClipPoses::of_palettes, py::arg("model"), py::arg("name"),
                  py::arg("palettes"), py::arg("morph_weights"), py::arg("offsets"))
      .def_static("of_vertices", &ClipPoses::of_vertices, py::arg("model"), py::arg("name"),
                  py::arg("vertices"))
      .def_property_readonly("frame_count", &ClipPoses::frame_count);
  module.def("posed_vertices", &all_posed_vertices, py::arg("poses"), py::arg("run"));
}

}  // namespace pelt::python
