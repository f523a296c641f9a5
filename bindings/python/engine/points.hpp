#pragma once

/// Points and vectors of arguments.

#include <pelt/distance.hpp>
#include <pelt/math.hpp>

#include "bindings/python/engine/array_view.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace pelt::python {

/// Points [P, 3] for all frames, or [F, P, 3].
class FramePoints {
 public:
  /// Throws an error that starts with `name` if there is neither one set of points nor one for each
  /// frame.
  FramePoints(const py::array& points, const std::string& name, std::size_t frames)
      : name_(name), view_(points, name) {
    check_shape(
        points, name,
        {points.ndim() == 3 && points.shape(0) == 1 ? 1 : static_cast<py::ssize_t>(frames), -1, 3},
        "[P, 3] or [" + std::to_string(frames) + ", P, 3]");
  }

  /// P
  std::size_t count() const { return view_.size(1); }

  /// Writes the points of a frame. Throws an error if a coordinate is NaN, or its magnitude is more
  /// than `limit`.
  void read(std::size_t frame, float limit, std::vector<Vec3>& points) const {
    const std::size_t row = view_.size(0) == 1 ? 0 : frame;
    points.resize(count());
    for (std::size_t p = 0; p < points.size(); ++p) {
      points[p] = {view_.at(row, p, 0), view_.at(row, p, 1), view_.at(row, p, 2)};
      for (const float coordinate : {points[p].x, points[p].y, points[p].z})
        if (!(std::abs(coordinate) <= limit)) throw ArgumentError(message(row, p, coordinate));
    }
  }

 private:
  std::string message(std::size_t row, std::size_t point, float coordinate) const {
    const std::string frame = view_.size(0) == 1 ? "" : "frame " + std::to_string(row) + ", ";
    return name_ + ": " + frame + "row " + std::to_string(point) + " has the coordinate " +
           std::to_string(coordinate) + ", which is not finite or too large";
  }

  std::string name_;
  FloatView view_;
};

/// Limit of the coordinates of points that queries accept.
inline constexpr float kLargestCoordinate = 0x1p60F;

/// Columns of points of surfaces: triangles, barycentric coordinates and positions.
struct SurfacePointColumns {
  std::int32_t* triangle;  // [N] -1: nothing found
  float* barycentrics;     // [N][3]
  float* position;         // [N][3]

  void set(std::size_t place, const SurfacePoint& point) const {
    triangle[place] = static_cast<std::int32_t>(point.triangle);
    std::copy(point.barycentrics.begin(), point.barycentrics.end(), barycentrics + 3 * place);
    set_vector(position, place, point.position);
  }

  void set_nothing(std::size_t place) const {
    triangle[place] = -1;
    std::fill_n(barycentrics + 3 * place, 3, NAN);
    std::fill_n(position + 3 * place, 3, NAN);
  }

  static void set_vector(float* column, std::size_t place, const Vec3& vector) {
    column[3 * place] = vector.x;
    column[3 * place + 1] = vector.y;
    column[3 * place + 2] = vector.z;
  }
};

}  // namespace pelt::python
