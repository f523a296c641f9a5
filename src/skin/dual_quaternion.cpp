#include "skin/dual_quaternion.hpp"

#include "base/vec3.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {
namespace {

/// A quaternion in double; r is its vector part.
struct Quaternion {
  Vec3d r;
  double w = 0;
};

double squared_length(const Quaternion& q) { return squared_length(q.r) + q.w * q.w; }

Quaternion operator*(double s, const Quaternion& q) { return {s * q.r, s * q.w}; }

Quaternion normalised(const Quaternion& q) { return 1 / std::sqrt(squared_length(q)) * q; }

Quaternion load(const float* q) {
  return {Vec3d(Vec3{q[0], q[1], q[2]}), static_cast<double>(q[3])};
}

void store(const Quaternion& q, float* out) {
  const Vec3 r = to_float(q.r);
  out[0] = r.x, out[1] = r.y, out[2] = r.z, out[3] = static_cast<float>(q.w);
}

Vec3d column(const Matrix4& matrix, std::size_t column) {
  const float* m = matrix.m.data() + 4 * column;
  return Vec3d(Vec3{m[0], m[1], m[2]});
}

/// Returns a quaternion that is parallel to that of the rotation with these columns. Solves for the
/// largest element, so that nothing cancels.
Quaternion rotation_of(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  const double squares[] = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                            1 + x.x + y.y + z.z};
  switch (std::max_element(squares, squares + 4) - squares) {
    case 0:
      return {{squares[0], x.y + y.x, x.z + z.x}, y.z - z.y};
    case 1:
      return {{x.y + y.x, squares[1], y.z + z.y}, z.x - x.z};
    case 2:
      return {{x.z + z.x, y.z + z.y, squares[2]}, x.y - y.x};
    default:
      return {{y.z - z.y, z.x - x.z, x.y - y.x}, squares[3]};
  }
}

/// The product of half the translation, as a quaternion, and q.
Quaternion dual_part(const Vec3d& translation, const Quaternion& q) {
  return 0.5 * Quaternion{q.w * translation + cross(translation, q.r), -dot(translation, q.r)};
}

Problem find_not_rigid(const Vec3d (&axes)[3], std::size_t joint) {
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 3; ++column) {
      const double error = dot(axes[row], axes[column]) - (row == column ? 1 : 0);
      if (!(std::fabs(error) <= kRigidTolerance))
        return problem(
            "palette[%zu] is not rigid: A^T A - I has %g at row %d, column %d, expected 0 (dual "
            "quaternion skinning needs joints without scale and shear)",
            joint, error, row, column);
    }
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0)
    return problem("palette[%zu] mirrors, but dual quaternion skinning needs rigid joints", joint);
  return {};
}

}  // namespace

Problem to_dual_quaternion(const Matrix4& matrix, std::size_t joint, DualQuaternion& out) {
  const Vec3d axes[] = {column(matrix, 0), column(matrix, 1), column(matrix, 2)};
  if (Problem found = find_not_rigid(axes, joint); !found.empty()) return found;
  const Quaternion q = normalised(rotation_of(axes[0], axes[1], axes[2]));
  store(q, out.real);
  store(dual_part(column(matrix, 3), q), out.dual);
  return {};
}

Problem to_dual_quaternion(const float* floats, std::size_t joint, DualQuaternion& out) {
  for (int i = 0; i < 8; ++i)
    if (!std::isfinite(floats[i]))
      return problem("dual_quaternions[%zu] has the element %g at %d", joint,
                     static_cast<double>(floats[i]), i);
  const Quaternion q = load(floats), e = load(floats + 4);
  const double square = squared_length(q);
  if (!(std::fabs(square - 1) <= kRigidTolerance))
    return problem("dual_quaternions[%zu] has a real part of squared length %g, expected 1", joint,
                   square);
  const double along = (dot(q.r, e.r) + q.w * e.w) / square, scale = 1 / std::sqrt(square);
  store(scale * q, out.real);
  store(scale * Quaternion{e.r - along * q.r, e.w - along * q.w}, out.dual);
  return {};
}

Matrix4 to_matrix(const DualQuaternion& motion) {
  const Quaternion q = load(motion.real), e = load(motion.dual);
  const double s = 2 / squared_length(q), x = q.r.x, y = q.r.y, z = q.r.z, w = q.w;
  const Vec3d columns[] = {{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
                           {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
                           {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)},
                           s * (w * e.r - e.w * q.r + cross(q.r, e.r))};
  Matrix4 matrix;
  for (std::size_t column = 0; column < 4; ++column) {
    const Vec3 v = to_float(columns[column]);
    matrix.m[4 * column] = v.x, matrix.m[4 * column + 1] = v.y, matrix.m[4 * column + 2] = v.z;
  }
  return matrix;
}

}  // namespace pelt::detail
