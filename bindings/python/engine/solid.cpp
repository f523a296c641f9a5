#include <pelt/solid.hpp>

#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/distance_columns.hpp"
#include "bindings/python/engine/frame_lists.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace pelt::python {
namespace {

using Numbers = const float*;

Vec3 vector_at(Numbers numbers) { return {numbers[0], numbers[1], numbers[2]}; }

void check_not_negative(float number, const char* name) {
  if (number < 0)
    throw ArgumentError(std::string(name) + ": expected 0 or more, found " +
                        std::to_string(number));
}

Solid half_space(Numbers n) {
  if (n[0] == 0 && n[1] == 0 && n[2] == 0) throw ArgumentError("normal: is zero");
  return HalfSpace{vector_at(n), n[3]};
}

Solid box(Numbers n) {
  for (int axis = 0; axis < 3; ++axis)
    if (n[axis] > n[3 + axis]) throw ArgumentError("low: is above high");
  return Box{vector_at(n), vector_at(n + 3)};
}

Solid oriented_box(Numbers n) {
  for (int axis = 0; axis < 3; ++axis) check_not_negative(n[12 + axis], "half");
  return OrientedBox{
      vector_at(n), {vector_at(n + 3), vector_at(n + 6), vector_at(n + 9)}, vector_at(n + 12)};
}

Solid sphere(Numbers n) {
  check_not_negative(n[3], "radius");
  return Sphere{vector_at(n), n[3]};
}

Solid capsule(Numbers n) {
  check_not_negative(n[6], "radius");
  return Capsule{vector_at(n), vector_at(n + 3), n[6]};
}

struct Kind {
  const char* name;
  std::size_t count;
  Solid (*make)(Numbers);
};

constexpr Kind kKinds[] = {{"HalfSpace", 4, half_space},
                           {"Box", 6, box},
                           {"OrientedBox", 15, oriented_box},
                           {"Sphere", 4, sphere},
                           {"Capsule", 7, capsule}};

const Kind& kind_of(const std::string& name) {
  for (const Kind& kind : kKinds)
    if (name == kind.name) return kind;
  throw ArgumentError("solid: there is no kind " + name);
}

Solid make_solid(const Kind& kind, const std::vector<float>& numbers) {
  for (const float number : numbers)
    if (!std::isfinite(number)) throw ArgumentError("has a number that is not a finite float32");
  return kind.make(numbers.data());
}

/// A solid that stands still, or that has numbers of its own in each frame. Valid for all queries.
class ClipSolid {
 public:
  /// `kind_name`: the name of a class of Python, such as "Sphere".
  /// `numbers`: [F, n] or [1, n] the members of the solid, in order.
  ///
  /// Throws an error that names the frame and the member if a number is invalid.
  ClipSolid(const std::string& kind_name, const py::array& numbers) {
    const Kind& kind = kind_of(kind_name);
    check_shape(numbers, kind_name, {-1, static_cast<py::ssize_t>(kind.count)},
                "[F, " + std::to_string(kind.count) + "]");
    if (numbers.shape(0) == 0) throw ArgumentError(kind_name + ": there are no frames");
    const FloatView view(numbers, kind_name);
    std::vector<float> members(kind.count);
    for (std::size_t frame = 0; frame < view.size(0); ++frame) {
      view.copy(frame, members.data());
      try {
        solids_.push_back(make_solid(kind, members));
      } catch (const ArgumentError& error) {
        const std::string place = view.size(0) == 1 ? "" : ", frame " + std::to_string(frame);
        throw ArgumentError(kind_name + place + ": " + error.what());
      }
    }
  }

  /// F, or 1 for a solid that stands still.
  std::size_t frame_count() const { return solids_.size(); }

  const Solid& at(std::size_t frame) const { return solids_[solids_.size() == 1 ? 0 : frame]; }

 private:
  std::vector<Solid> solids_;
};

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
