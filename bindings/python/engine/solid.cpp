#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/clip_solid.hpp"
#include "bindings/python/engine/distance_columns.hpp"
#include "bindings/python/engine/frame_lists.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <tuple>

namespace pelt::python {
namespace {

using Column = py::array_t<std::int32_t>;

/// A triangle that touches a solid.
struct Touching {
  std::uint32_t triangle = 0;
  bool is_inside = false;
};

/// Frame, triangle, and whether the triangle is wholly in the solid [N].
using TouchingColumns = std::tuple<Column, Column, py::array_t<bool>>;

std::size_t common_frame_count(const ClipPoses& poses, const ClipSolid& solid) {
  const std::size_t of_poses = poses.frame_count(), of_solid = solid.frame_count();
  if (of_solid == 1 || of_poses == of_solid) return of_poses;
  if (of_poses == 1) return of_solid;
  throw ArgumentError(poses.name() + " has " + std::to_string(of_poses) +
                      " frames, but the solid has " + std::to_string(of_solid) +
                      " (expected equal numbers, or one frame)");
}

Region region_of(const Solid& solid) {
  return std::visit([](const auto& shape) { return Region(shape); }, solid);
}

/// Appends the triangles of both lists, which ascend.
void append(const TrianglesInRegion& found, std::vector<Touching>& list) {
  auto inside = found.inside.begin();
  for (const std::uint32_t triangle : found.intersecting) {
    const bool is_inside = inside != found.inside.end() && *inside == triangle;
    if (is_inside) ++inside;
    list.push_back({triangle, is_inside});
  }
}

TouchingColumns columns_of(const FrameLists<Touching>& lists) {
  const std::size_t count = lists.size();
  TouchingColumns columns = {new_array<std::int32_t>({count}), new_array<std::int32_t>({count}),
                             new_array<bool>({count})};
  auto& [frames, triangles, insides] = columns;
  std::int32_t* const frame_of = frames.mutable_data();
  std::int32_t* const triangle_of = triangles.mutable_data();
  bool* const is_inside = insides.mutable_data();
  lists.for_each([&](std::size_t place, std::size_t frame, const Touching& touching) {
    frame_of[place] = static_cast<std::int32_t>(frame);
    triangle_of[place] = static_cast<std::int32_t>(touching.triangle);
    is_inside[place] = touching.is_inside;
  });
  return columns;
}

TouchingColumns all_touching(const ClipPoses& poses, const ClipSolid& solid, const Run& run) {
  FrameLists<Touching> lists(common_frame_count(poses, solid));
  run_frames(lists.frame_count(), run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    TrianglesInRegion found;
    std::vector<Touching>& list = lists.add_thread();
    while (const auto frame = queue.next()) {
      found.intersecting.clear();
      found.inside.clear();
      find_triangles(pose.at(*frame), region_of(solid.at(*frame)), scratch, found);
      const std::size_t begin = list.size();
      append(found, list);
      lists.set(*frame, list, begin);
    }
  });
  return columns_of(lists);
}

/// Distance, triangle, barycentrics and position on the surface, and position on the solid.
using SolidColumns = std::tuple<py::array_t<double>, Column, py::array_t<float>, py::array_t<float>,
                                py::array_t<float>>;

SolidColumns all_solid_distances(const ClipPoses& poses, const ClipSolid& solid,
                                 double max_distance, const Run& run) {
  check_distance(max_distance, "max_distance");
  const std::size_t frames = common_frame_count(poses, solid);
  SolidColumns columns = {new_array<double>({frames}), new_array<std::int32_t>({frames}),
                          new_array<float>({frames, 3}), new_array<float>({frames, 3}),
                          new_array<float>({frames, 3})};
  auto& [distances, triangles, weights, positions, on_solid] = columns;
  double* const out = distances.mutable_data();
  float* const point = on_solid.mutable_data();
  const SurfacePointColumns surface = {triangles.mutable_data(), weights.mutable_data(),
                                       positions.mutable_data()};
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    while (const auto frame = queue.next()) {
      SolidDistance found;
      distance(pose.at(*frame), solid.at(*frame), scratch, found, {.max_distance = max_distance});
      out[*frame] = found.distance;
      surface.set_nothing(*frame);
      SurfacePointColumns::set_vector(point, *frame, {NAN, NAN, NAN});
      if (!found) continue;
      surface.set(*frame, found.surface);
      SurfacePointColumns::set_vector(point, *frame, found.solid);
    }
  });
  return columns;
}

}  // namespace

void add_solid(py::module_& module) {
  py::class_<ClipSolid>(module, "ClipSolid")
      .def(py::init<const std::string&, const py::array&>(), py::arg("kind"), py::arg("numbers"))
      .def_property_readonly("frame_count", &ClipSolid::frame_count);
  module.def("collide_solid", &all_touching, py::arg("poses"), py::arg("solid"), py::arg("run"));
  module.def("solid_distance", &all_solid_distances, py::arg("poses"), py::arg("solid"),
             py::arg("max_distance"), py::arg("run"));
}

}  // namespace pelt::python
