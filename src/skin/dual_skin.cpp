#include "skin/dual_skin.hpp"
#include "base/vec3.hpp"

#include <cmath>

namespace pelt::detail {

Problem find_not_rigid(const float* matrix, std::size_t joint) {
  const auto axis = [&](std::size_t column) {
    const float* const m = matrix + 4 * column;
    return Vec3d(Vec3{m[0], m[1], m[2]});
  };
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = row; column < 3; ++column) {
      const double error = dot(axis(row), axis(column)) - (row == column ? 1 : 0);
      if (!(std::fabs(error) <= kRigidTolerance))
        return problem(
            "palette[%zu] is not rigid: A^T A - I has %g at row %zu, column %zu, expected 0 (dual "
            "quaternion skinning needs joints without scale and shear)",
            joint, error, row, column);
    }
  if (dot(cross(axis(0), axis(1)), axis(2)) < 0)
    return problem("palette[%zu] mirrors, but dual quaternion skinning needs rigid joints", joint);
  return {};
}

Problem find_not_unit(const float* dual, std::size_t joint) {
  for (int i = 0; i < 8; ++i)
    if (!std::isfinite(dual[i]))
      return problem("dual_quaternions[%zu] has the element %g at %d", joint,
                     static_cast<double>(dual[i]), i);
  const Vec3d r(dual[0], dual[1], dual[2]);
  const double w = dual[3], square = squared_length(r) + w * w;
  if (std::fabs(square - 1) <= kRigidTolerance) return {};
  return problem("dual_quaternions[%zu] has a real part of squared length %g, expected 1", joint,
                 square);
}

}  // namespace pelt::detail
