#include "model/symmetric3.hpp"

#include <cmath>
#include <utility>

namespace pelt::detail {
namespace {

/// One rotation of Jacobi's method (Golub & Van Loan, Matrix Computations, 8.5): makes m[p][q] zero
/// and rotates the axes p and q in the same way.
void rotate(double (&m)[3][3], std::array<Vec3d, 3>& axes, int p, int q) {
  if (m[p][q] == 0) return;
  const double slope = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (slope >= 0 ? 1 : -1) / (std::fabs(slope) + std::sqrt(1 + slope * slope));
  const double c = 1 / std::sqrt(1 + t * t), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const double kp = m[k][p], kq = m[k][q];
    m[k][p] = c * kp - s * kq, m[k][q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; ++k) {
    const double pk = m[p][k], qk = m[q][k];
    m[p][k] = c * pk - s * qk, m[q][k] = s * pk + c * qk;
  }
  const Vec3d axis_p = c * axes[p] - s * axes[q];
  axes[q] = s * axes[p] + c * axes[q];
  axes[p] = axis_p;
}

}  // namespace

std::array<Vec3d, 3> eigenvectors(const Symmetric3& a) {
  double m[3][3] = {{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}};
  std::array<Vec3d, 3> axes = {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  constexpr int kSweeps = 8;  // quadratic convergence: four reach the precision of double
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  return axes;
}

Vec3d solve(const Symmetric3& a, const Vec3d& b) {
  const Vec3d x{a.xx, a.xy, a.xz}, y{a.xy, a.yy, a.yz}, z{a.xz, a.yz, a.zz};
  const Vec3d yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  return (1 / dot(x, yz)) * (b.x * yz + b.y * zx + b.z * xy);
}

}  // namespace pelt::detail
