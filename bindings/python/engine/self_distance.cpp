#include "bindings/python/engine/argument_error.hpp"
#include "bindings/python/engine/bindings.hpp"
#include "bindings/python/engine/clip_poses.hpp"
#include "bindings/python/engine/edge_distances.hpp"
#include "bindings/python/engine/run_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pelt::python {
namespace {

/// V^2 / 8 bytes are 320 MB.
constexpr std::size_t kMaxVertices = 50'000;

std::vector<Vec3> rest_positions(const py::array& array) {
  check_shape(array, "rest", {-1, 3}, "[V, 3]");
  const FloatView view(array, "rest");
  if (view.size(0) > kMaxVertices)
    throw ArgumentError("rest: " + std::to_string(view.size(0)) + " vertices, at most " +
                        std::to_string(kMaxVertices));
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < view.size(0); ++v) {
    positions.push_back({view.at(v, 0), view.at(v, 1), view.at(v, 2)});
    if (!std::isfinite(positions[v].x + positions[v].y + positions[v].z))
      throw ArgumentError("rest: vertex " + std::to_string(v) + " is not finite");
  }
  return positions;
}

std::vector<Triangle> face_indices(const Integers& array, std::size_t vertices) {
  check_shape(array, "faces", {-1, 3}, "[T, 3]");
  const auto indices = indices_of<std::uint32_t>(array, "faces", vertices);
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    faces.push_back({indices[i], indices[i + 1], indices[i + 2]});
  return faces;
}

NearAlongEdges make_near(const py::array& rest, const Integers& faces, double limit,
                         const Run& run) {
  const std::vector<Vec3> positions = rest_positions(rest);
  return {positions, face_indices(faces, positions.size()), limit, run};
}

struct Neighbour {
  float distance = std::numeric_limits<float>::infinity();
  std::int32_t vertex = -1;
};

/// Posed vertices sorted by the cells of a grid, whose cells are at least as wide as a distance.
class Grid {
 public:
  Grid(std::span<const Vec3> points, double distance) : points_(points) {
    Vec3 high = low_ = points.empty() ? Vec3{0, 0, 0} : points[0];
    for (const Vec3& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double extent =
        std::max({double{high.x} - low_.x, double{high.y} - low_.y, double{high.z} - low_.z});
    cell_ = std::max(distance * 1.000001, extent / kMaxCells);
    for (std::size_t v = 0; v < points.size(); ++v)
      cells_.emplace_back(key(cell_of(points[v])), static_cast<std::uint32_t>(v));
    std::sort(cells_.begin(), cells_.end());
  }

  /// Calls `visit(other)` for all points in the cell of a point and in the cells around it.
  template <class Visit>
  void visit_around(std::size_t point, const Visit& visit) const {
    const Cell cell = cell_of(points_[point]);
    for (const std::uint64_t x : {cell[0] - 1, cell[0], cell[0] + 1})
      for (const std::uint64_t y : {cell[1] - 1, cell[1], cell[1] + 1}) {
        const std::uint64_t last = key({x, y, cell[2] + 1});
        auto entry =
            std::lower_bound(cells_.begin(), cells_.end(), Entry{key({x, y, cell[2] - 1}), 0});
        for (; entry != cells_.end() && entry->first <= last; ++entry) visit(entry->second);
      }
  }

 private:
  using Cell = std::array<std::uint64_t, 3>;
  using Entry = std::pair<std::uint64_t, std::uint32_t>;

  static constexpr double kMaxCells = 1 << 20;

  /// Cells count from 1, so that those around them exist.
  Cell cell_of(const Vec3& p) const {
    const auto along = [&](float value, float low) {
      return static_cast<std::uint64_t>((double{value} - low) / cell_) + 1;
    };
    return {along(p.x, low_.x), along(p.y, low_.y), along(p.z, low_.z)};
  }

  static std::uint64_t key(const Cell& cell) { return cell[0] << 42 | cell[1] << 21 | cell[2]; }

  std::span<const Vec3> points_;
  Vec3 low_;
  double cell_ = 1;
  std::vector<Entry> cells_;
};

/// Returns an upper bound of the computed x*x + y*y + z*z of all vectors no longer than `distance`.
double rounded_up_square(double distance) { return distance * distance * (1 + 1e-12); }

/// Returns the closest vertex that is not near along the edges, up to a distance. Of equally
/// distant vertices, the lowest.
Neighbour closest_far_vertex(std::span<const Vec3> points, const Grid& grid,
                             const NearAlongEdges& near, std::size_t vertex, double limit) {
  Neighbour closest;
  double least = limit, least_square = rounded_up_square(limit);
  grid.visit_around(vertex, [&](std::uint32_t other) {
    const Vec3 &p = points[vertex], &q = points[other];
    const double x = double{p.x} - q.x, y = double{p.y} - q.y, z = double{p.z} - q.z;
    // Most vertices are farther, or near along the edges. `hypot` is only for the others.
    if (x * x + y * y + z * z > least_square || near.near(vertex, other)) return;
    const double distance = std::hypot(x, y, z);
    const auto index = static_cast<std::int32_t>(other);
    if (distance > least || (distance == least && (closest.vertex < 0 || index > closest.vertex)))
      return;
    least = distance;
    least_square = rounded_up_square(least);
    closest = {static_cast<float>(distance), index};
  });
  return closest;
}

/// Distances [F, V], infinite if nothing is nearer than the limit, and vertices [F, V] or -1.
using Columns = std::pair<py::array_t<float>, py::array_t<std::int32_t>>;

Columns all_self_distances(const ClipPoses& poses, const NearAlongEdges& near, double limit,
                           const Run& run) {
  const std::size_t frames = poses.frame_count(), count = poses.model().vertex_count();
  if (near.vertex_count() != count)
    throw ArgumentError("geodesics: made for " + std::to_string(near.vertex_count()) +
                        " vertices, but the model has " + std::to_string(count));
  Columns columns = {new_array<float>({frames, count}), new_array<std::int32_t>({frames, count})};
  float* const distances = columns.first.mutable_data();
  std::int32_t* const vertices = columns.second.mutable_data();
  run_frames(frames, run, [&](FrameQueue& queue) {
    FramePose pose(poses);
    std::vector<Vec3> points(count);
    while (const auto frame = queue.next()) {
      posed_vertices(pose.at(*frame), points);
      const Grid grid(points, limit);
      for (std::size_t v = 0; v < count; ++v) {
        const Neighbour found = closest_far_vertex(points, grid, near, v, limit);
        distances[*frame * count + v] = found.distance;
        vertices[*frame * count + v] = found.vertex;
      }
    }
  });
  return columns;
}

}  // namespace

void add_self_distance(py::module_& module) {
  py::class_<NearAlongEdges>(module, "NearAlongEdges")
      .def(py::init(&make_near), py::arg("rest"), py::arg("faces"), py::arg("limit"),
           py::arg("run"));
  module.def("self_distances", &all_self_distances, py::arg("poses"), py::arg("near"),
             py::arg("limit"), py::arg("run"));
}

}  // namespace pelt::python
