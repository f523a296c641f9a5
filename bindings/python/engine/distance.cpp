#include <pelt/distance.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/distance_columns.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <tuple>

namespace pelt::python {
namespace {

using Triangles = py::array_t<std::int32_t>;
using Floats = py::array_t<float>;

/// Distance, then triangle, barycentrics and position.
using ClosestColumns = std::tuple<py::array_t<double>, Triangles, Floats, Floats>;

/// Distances of all frames [F], with the closest points.
DistanceColumns all_distances(const ClipPoses& a, const ClipPoses& b, double max_distance,
                              double tolerance, const Run& run) {
  check_distance(max_distance, "max_distance");
  check_distance(tolerance, "tolerance");
  const std::size_t frames = common_frame_count(a, b);
  const DistanceTable table(frames);
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    while (const auto frame = queue.next()) {
      Distance found;
      distance(pose_a.at(*frame), pose_b.at(*frame), scratch, found, {max_distance, tolerance});
      table.set(*frame, found);
    }
  });
  return table.columns();
}

/// The closest points of all frames [F, P].
ClosestColumns all_closest_points(const ClipPoses& poses, const py::array& points,
                                  double max_distance, const Run& run) {
  check_distance(max_distance, "max_distance");
  const std::size_t frames = poses.frame_count();
  const FramePoints given(points, "points", frames);
  const std::size_t count = given.count();
  ClosestColumns columns = {
      new_array<double>({frames, count}), new_array<std::int32_t>({frames, count}),
      new_array<float>({frames, count, 3}), new_array<float>({frames, count, 3})};
  auto& [distances, triangles, weights, positions] = columns;
  double* const out = distances.mutable_data();
  const SurfacePointColumns on_surface = {triangles.mutable_data(), weights.mutable_data(),
                                          positions.mutable_data()};
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    std::vector<Vec3> read;
    std::vector<ClosestPoint> found(count);
    while (const auto frame = queue.next()) {
      given.read(*frame, kLargestCoordinate, read);
      closest_points(pose.at(*frame), read, scratch, found, {.max_distance = max_distance});
      for (std::size_t p = 0; p < count; ++p) {
        const std::size_t place = *frame * count + p;
        out[place] = found[p].distance;
        if (found[p])
          on_surface.set(place, found[p].point);
        else
          on_surface.set_nothing(place);
      }
    }
  });
  return columns;
}

}  // namespace

void add_distance(py::module_& module) {
  module.def("distance", &all_distances, py::arg("a"), py::arg("b"), py::arg("max_distance"),
             py::arg("tolerance"), py::arg("run"));
  module.def("closest_points", &all_closest_points, py::arg("poses"), py::arg("points"),
             py::arg("max_distance"), py::arg("run"));
}

}  // namespace pelt::python
