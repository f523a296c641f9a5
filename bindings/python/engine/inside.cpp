#include <pelt/inside.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <limits>
#include <tuple>

namespace pelt::python {
namespace {

/// Throws an error if the surface of the poses' model is not closed.
void require_inside(const ClipPoses& poses) {
  const py::gil_scoped_release unlocked;
  if (poses.model().surface().is_closed()) return;
  throw ArgumentError(poses.name() +
                      ": the surface of the model is not closed, so it has no inside");
}

std::int8_t number_of(PointSide side) {
  return static_cast<std::int8_t>(static_cast<int>(side) - static_cast<int>(PointSide::on));
}

/// Computes something of each point [F, P]. `answer(pose, point, scratch)` returns an Element.
template <class Element, class Answer>
py::array_t<Element> for_each_point(const ClipPoses& poses, const py::array& points, const Run& run,
                                    const Answer& answer) {
  const std::size_t frames = poses.frame_count();
  const FramePoints given(points, "points", frames);
  const std::size_t count = given.count();
  py::array_t<Element> result = new_array<Element>({frames, count});
  Element* const out = result.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    Scratch scratch;
    std::vector<Vec3> read;
    while (const auto frame = queue.next()) {
      given.read(*frame, kLargestCoordinate, read);
      for (std::size_t p = 0; p < count; ++p)
        out[*frame * count + p] = answer(pose.at(*frame), read[p], scratch);
    }
  });
  return result;
}

/// The sides of points [F, P]: -1 outside, 0 on the surface, 1 inside.
py::array_t<std::int8_t> all_sides(const ClipPoses& poses, const py::array& points,
                                   const Run& run) {
  require_inside(poses);
  return for_each_point<std::int8_t>(poses, points, run,
                                     [&](Pose& pose, const Vec3& point, Scratch& scratch) {
                                       PointSide side = PointSide::outside;
                                       side_of(pose, point, scratch, side);
                                       return number_of(side);
                                     });
}

/// The winding numbers around points [F, P]; 0 for points on the surface.
py::array_t<std::int32_t> all_windings(const ClipPoses& poses, const py::array& points,
                                       const Run& run) {
  require_inside(poses);
  return for_each_point<std::int32_t>(poses, points, run,
                                      [&](Pose& pose, const Vec3& point, Scratch& scratch) {
                                        std::int32_t winding = 0;
                                        winding_number(pose, point, scratch, winding);
                                        return winding;
                                      });
}

/// The sides of the vertices of a [F, V] with respect to b.
py::array_t<std::int8_t> all_vertex_sides(const ClipPoses& a, const ClipPoses& b, const Run& run) {
  require_inside(b);
  const std::size_t frames = common_frame_count(a, b), count = a.model().vertex_count();
  py::array_t<std::int8_t> result = new_array<std::int8_t>({frames, count});
  std::int8_t* const out = result.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    std::vector<Vec3> vertices(count);
    while (const auto frame = queue.next()) {
      posed_vertices(pose_a.at(*frame), vertices);
      for (std::size_t v = 0; v < count; ++v) {
        PointSide side = PointSide::outside;
        side_of(pose_b.at(*frame), vertices[v], scratch, side);
        out[*frame * count + v] = number_of(side);
      }
    }
  });
  return result;
}

/// Vertex [F], depth [F], position of the vertex [F, 3], closest triangle [F] and point [F, 3].
using DepthColumns = std::tuple<py::array_t<std::int32_t>, py::array_t<double>, py::array_t<float>,
                                py::array_t<std::int32_t>, py::array_t<float>, py::array_t<float>>;

DepthColumns all_deepest_vertices(const ClipPoses& a, const ClipPoses& b, const Run& run) {
  require_inside(b);
  const std::size_t frames = common_frame_count(a, b);
  DepthColumns columns = {new_array<std::int32_t>({frames}), new_array<double>({frames}),
                          new_array<float>({frames, 3}),     new_array<std::int32_t>({frames}),
                          new_array<float>({frames, 3}),     new_array<float>({frames, 3})};
  auto& [vertices, depths, positions, triangles, weights, points] = columns;
  std::int32_t* const vertex = vertices.mutable_data();
  double* const depth = depths.mutable_data();
  float* const position = positions.mutable_data();
  const SurfacePointColumns closest = {triangles.mutable_data(), weights.mutable_data(),
                                       points.mutable_data()};
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose_a(a), pose_b(b);
    Scratch scratch;
    while (const auto frame = queue.next()) {
      Penetration found;
      deepest_vertex(pose_a.at(*frame), pose_b.at(*frame), scratch, found);
      vertex[*frame] = found ? static_cast<std::int32_t>(found.vertex) : -1;
      depth[*frame] = found.depth;
      closest.set_nothing(*frame);
      const float nothing = std::numeric_limits<float>::quiet_NaN();
      SurfacePointColumns::set_vector(position, *frame,
                                      found ? found.position : Vec3{nothing, nothing, nothing});
      if (found) closest.set(*frame, found.closest);
    }
  });
  return columns;
}

}  // namespace

void add_inside(py::module_& module) {
  module.def("side_of", &all_sides, py::arg("poses"), py::arg("points"), py::arg("run"));
  module.def("winding_numbers", &all_windings, py::arg("poses"), py::arg("points"), py::arg("run"));
  module.def("vertex_sides", &all_vertex_sides, py::arg("a"), py::arg("b"), py::arg("run"));
  module.def("deepest_vertex", &all_deepest_vertices, py::arg("a"), py::arg("b"), py::arg("run"));
}

}  // namespace pelt::python
