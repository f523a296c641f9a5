#include <pelt/height_field.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/distance_columns.hpp"
#include "bindings/python/engine/pair_lists.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <array>

namespace pelt::python {
namespace {

HeightField make_field(const py::array& heights, std::array<float, 3> origin, float column_spacing,
                       float row_spacing) {
  check_shape(heights, "heights", {-1, -1}, "[rows, columns]");
  const FloatView view(heights, "heights");
  HeightGrid grid;
  grid.rows = static_cast<std::uint32_t>(view.size(0));
  grid.columns = static_cast<std::uint32_t>(view.size(1));
  grid.origin = {origin[0], origin[1], origin[2]};
  grid.column_spacing = column_spacing;
  grid.row_spacing = row_spacing;
  std::vector<float> copy(view.size(0) * view.size(1));
  for (std::size_t row = 0; row < view.size(0); ++row)
    view.copy(row, copy.data() + row * view.size(1));
  grid.heights = copy;
  const py::gil_scoped_release unlocked;
  return value_of(build_height_field(grid), "HeightField");
}

/// The vertices of all triangles [T, 3, 3].
py::array_t<float> triangles_of(const HeightField& field) {
  py::array_t<float> result = new_array<float>({field.triangle_count(), 3, 3});
  float* out = result.mutable_data();
  for (std::uint32_t t = 0; t < field.triangle_count(); ++t)
    for (const Vec3& vertex : field.triangle(t))
      for (const float coordinate : {vertex.x, vertex.y, vertex.z}) *out++ = coordinate;
  return result;
}

PairColumns all_field_contacts(const ClipPoses& poses, const HeightField& field,
                               std::uint32_t max_contacts, const Run& run) {
  PairLists<Contact> found(poses.frame_count());
  run_frames(poses.frame_count(), run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    std::vector<Contact>& list = found.lists.add_thread();
    while (const auto frame = queue.next()) {
      const std::size_t begin = list.size();
      const QueryStats stats = collide(pose.at(*frame), field, scratch, list, {max_contacts});
      found.lists.set(*frame, list, begin);
      found.cut_short[*frame] = stats.cut_short;
    }
  });
  return found.columns();
}

DistanceColumns all_field_distances(const ClipPoses& poses, const HeightField& field,
                                    double max_distance, const Run& run) {
  check_distance(max_distance, "max_distance");
  const DistanceTable table(poses.frame_count());
  run_frames(poses.frame_count(), run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    while (const auto frame = queue.next()) {
      Distance found;
      distance(pose.at(*frame), field, scratch, found, {.max_distance = max_distance});
      table.set(*frame, found);
    }
  });
  return table.columns();
}

}  // namespace

void add_height_field(py::module_& module) {
  py::class_<HeightField>(module, "HeightField")
      .def(py::init(&make_field), py::arg("heights"), py::arg("origin"), py::arg("column_spacing"),
           py::arg("row_spacing"))
      .def_property_readonly("rows", &HeightField::rows)
      .def_property_readonly("columns", &HeightField::columns)
      .def_property_readonly("triangle_count", &HeightField::triangle_count)
      .def_property_readonly("triangles", &triangles_of);
  module.def("collide_field", &all_field_contacts, py::arg("poses"), py::arg("field"),
             py::arg("max_contacts"), py::arg("run"));
  module.def("field_distance", &all_field_distances, py::arg("poses"), py::arg("field"),
             py::arg("max_distance"), py::arg("run"));
}

}  // namespace pelt::python
