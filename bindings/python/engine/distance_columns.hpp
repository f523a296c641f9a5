#pragma once

/// Distances of frames as NumPy arrays.

#include <pelt/distance.hpp>

#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/points.hpp"

#include <cstddef>
#include <string>
#include <tuple>

namespace pelt::python {

/// Throws an error that starts with `name` if a distance is negative or NaN.
inline void check_distance(double value, const char* name) {
  if (!(value >= 0)) throw ArgumentError(std::string(name) + ": expected 0 or more");
}

/// Distance [F], then triangle [F], barycentrics and position [F, 3] on a, and the same on b.
using DistanceColumns =
    std::tuple<py::array_t<double>, py::array_t<std::int32_t>, py::array_t<float>,
               py::array_t<float>, py::array_t<std::int32_t>, py::array_t<float>,
               py::array_t<float>>;

/// The distances of F frames. Threads may set different frames at the same time.
class DistanceTable {
 public:
  explicit DistanceTable(std::size_t frames)
      : columns_(new_array<double>({frames}), new_array<std::int32_t>({frames}),
                 new_array<float>({frames, 3}), new_array<float>({frames, 3}),
                 new_array<std::int32_t>({frames}), new_array<float>({frames, 3}),
                 new_array<float>({frames, 3})) {
    auto& [distances, triangles_a, weights_a, points_a, triangles_b, weights_b, points_b] =
        columns_;
    distances_ = distances.mutable_data();
    a_ = {triangles_a.mutable_data(), weights_a.mutable_data(), points_a.mutable_data()};
    b_ = {triangles_b.mutable_data(), weights_b.mutable_data(), points_b.mutable_data()};
  }

  void set(std::size_t frame, const Distance& found) const {
    distances_[frame] = found.distance;
    a_.set_nothing(frame);
    b_.set_nothing(frame);
    if (!found) return;
    a_.set(frame, found.a);
    b_.set(frame, found.b);
  }

  const DistanceColumns& columns() const { return columns_; }

 private:
  DistanceColumns columns_;
  double* distances_ = nullptr;
  SurfacePointColumns a_, b_;
};

}  // namespace pelt::python
