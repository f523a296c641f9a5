#include <pelt/ray.hpp>

#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/points.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <cmath>
#include <limits>
#include <tuple>

namespace pelt::python {
namespace {

/// Triangle [F, R], t [F, R], barycentrics [F, R, 3] and normal [F, R, 3].
using RayColumns = std::tuple<py::array_t<std::int32_t>, py::array_t<float>, py::array_t<float>,
                              py::array_t<float>>;

/// The rays of all frames.
struct Rays {
  FramePoints origins, directions;
  float t_min, t_max;

  void read(std::size_t frame, std::vector<Vec3>& from, std::vector<Vec3>& along,
            std::vector<Ray>& rays) const {
    constexpr float kAnyFinite = std::numeric_limits<float>::max();
    origins.read(frame, kAnyFinite, from);
    directions.read(frame, kAnyFinite, along);
    rays.resize(from.size());
    for (std::size_t r = 0; r < rays.size(); ++r) rays[r] = {from[r], along[r], t_min, t_max};
  }
};

Rays rays_of(const py::array& origins, const py::array& directions, double t_min, double t_max,
             std::size_t frames) {
  if (std::isnan(t_min) || std::isnan(t_max)) throw ArgumentError("t_min, t_max: found NaN");
  Rays rays = {{origins, "origins", frames},
               {directions, "directions", frames},
               static_cast<float>(t_min),
               static_cast<float>(t_max)};
  if (rays.origins.count() != rays.directions.count())
    throw ArgumentError("directions: expected one for each of the " +
                        std::to_string(rays.origins.count()) + " origins, found " +
                        std::to_string(rays.directions.count()));
  return rays;
}

/// The first hits of all rays in all frames.
RayColumns cast_all_frames(const ClipPoses& poses, const py::array& origins,
                           const py::array& directions, double t_min, double t_max, Facing facing,
                           const Run& run) {
  const std::size_t frames = poses.frame_count();
  const Rays rays = rays_of(origins, directions, t_min, t_max, frames);
  const std::size_t count = rays.origins.count();
  RayColumns columns = {new_array<std::int32_t>({frames, count}), new_array<float>({frames, count}),
                        new_array<float>({frames, count, 3}), new_array<float>({frames, count, 3})};
  auto& [triangles, ts, weights, normals] = columns;
  std::int32_t* const triangle = triangles.mutable_data();
  float *const t = ts.mutable_data(), *const weight = weights.mutable_data(),
               *const normal = normals.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    std::vector<Vec3> from, along;
    std::vector<Ray> read;
    std::vector<RayHit> hits(count);
    while (const auto frame = queue.next()) {
      rays.read(*frame, from, along, read);
      cast(pose.at(*frame), read, hits, facing);
      for (std::size_t r = 0; r < count; ++r) {
        const std::size_t place = *frame * count + r;
        triangle[place] = hits[r] ? static_cast<std::int32_t>(hits[r].triangle) : -1;
        t[place] = hits[r].t;
        std::copy_n(hits[r].barycentrics.begin(), 3, weight + 3 * place);
        SurfacePointColumns::set_vector(normal, place, hits[r].normal);
      }
    }
  });
  return columns;
}

}  // namespace

void add_rays(py::module_& module) {
  py::enum_<Facing>(module, "Facing")
      .value("both", Facing::both)
      .value("front", Facing::front)
      .value("back", Facing::back);
  module.def("cast_rays", &cast_all_frames, py::arg("poses"), py::arg("origins"),
             py::arg("directions"), py::arg("t_min"), py::arg("t_max"), py::arg("facing"),
             py::arg("run"));
}

}  // namespace pelt::python
