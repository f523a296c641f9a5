#include "evaluation/rivals/cell_grid.hpp"

#include "base/vec3.hpp"

#include <cmath>

namespace pelt::rivals {

float mean_edge(std::span<const Triangle> triangles, std::span<const Vec3> positions) {
  double sum = 0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const detail::Vec3d from(positions[t[k]]), to(positions[t[(k + 1) % 3]]);
      sum += std::sqrt(squared_length(to - from));
    }
  return static_cast<float>(sum / (3.0 * static_cast<double>(triangles.size())));
}

}  // namespace pelt::rivals
