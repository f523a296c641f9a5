#include "bindings/wasm/engine/surface_points.hpp"

#include "bindings/wasm/engine/answer.hpp"

#include <vector>

namespace pelt::wasm {

void answer_points(std::initializer_list<PointOfPose> points) {
  static std::vector<double> rows;
  rows.clear();
  for (const auto& [point, pose] : points) {
    const auto& [x, y, z] = point.position;
    const auto& [u, v, w] = point.barycentrics;
    const std::uint32_t triangle = pose.body.first_triangle + point.triangle;
    rows.insert(rows.end(), {static_cast<double>(triangle), x, y, z, u, v, w});
  }
  answer_data<double>(rows);
}

}  // namespace pelt::wasm
