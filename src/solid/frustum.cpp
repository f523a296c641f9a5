#include <pelt/math.hpp>

#include "base/require.hpp"

#include <algorithm>
#include <cstddef>

namespace pelt {
namespace {

/// A clip coordinate as a linear function of (p, 1).
struct Row {
  double x, y, z, w;

  Row(const Matrix4& m, std::size_t row)
      : Row(static_cast<double>(m.m[row]), static_cast<double>(m.m[4 + row]),
            static_cast<double>(m.m[8 + row]), static_cast<double>(m.m[12 + row])) {}
  Row(double x_, double y_, double z_, double w_) : x(x_), y(y_), z(z_), w(w_) {}

  Row operator+(const Row& other) const {
    return {x + other.x, y + other.y, z + other.z, w + other.w};
  }
  Row operator-(const Row& other) const {
    return {x - other.x, y - other.y, z - other.z, w - other.w};
  }
};

/// Returns the half-space in which the function is not negative.
HalfSpace where_positive(const Row& row) {
  return {{static_cast<float>(-row.x), static_cast<float>(-row.y), static_cast<float>(-row.z)},
          static_cast<float>(row.w)};
}

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(std::span<const HalfSpace> faces) : count_(faces.size()) {
  detail::require(faces.size() <= kMaxFaces,
                  "ConvexPolyhedron: more than 64 faces; leave out those that cut nothing off");
  std::copy(faces.begin(), faces.end(), faces_.begin());
}

Frustum make_frustum(const Matrix4& view_projection, ClipDepth depth) {
  const Row x(view_projection, 0), y(view_projection, 1), z(view_projection, 2),
      w(view_projection, 3);
  const Row from_near = depth == ClipDepth::zero_to_one ? z : w + z;
  return {{where_positive(w + x), where_positive(w - x), where_positive(w + y),
           where_positive(w - y), where_positive(from_near), where_positive(w - z)}};
}

}  // namespace pelt
