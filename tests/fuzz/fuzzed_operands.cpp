#include "fuzz/fuzzed_operands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt::test {
namespace {

Box box_between(const Vec3& p, const Vec3& q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
          {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
}

Vec3 half_extents(FuzzBytes& bytes) {
  const float x = bytes.size(), y = bytes.size(), z = bytes.size();
  return {x, y, z};
}

HalfSpace make_half_space(FuzzBytes& bytes) {
  const Vec3 normal = bytes.point();
  return {normal, bytes.coordinate()};
}

Region make_polyhedron(FuzzBytes& bytes) {
  std::array<HalfSpace, 8> faces;
  const std::uint32_t count = bytes.index(faces.size() + 1);
  for (std::uint32_t i = 0; i < count; ++i) faces[i] = make_half_space(bytes);
  return ConvexPolyhedron(std::span(faces).first(count));
}

/// Orthogonal and sheared axes with small numbers, each scaled by a power of two.
std::array<Vec3, 3> make_axes(FuzzBytes& bytes) {
  constexpr std::array<std::array<Vec3, 3>, 5> kFrames = {{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                                           {{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}},
                                                           {{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}},
                                                           {{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}},
                                                           {{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}}}}};
  std::array<Vec3, 3> axes = kFrames[bytes.index(kFrames.size())];
  for (Vec3& axis : axes) {
    const float scale = std::ldexp(1.0f, static_cast<int>(bytes.index(9)) - 4);
    axis = {axis.x * scale, axis.y * scale, axis.z * scale};
  }
  return axes;
}

bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

}  // namespace

Ray make_ray(FuzzBytes& bytes, const FuzzedBody& body) {
  const std::uint32_t kind = bytes.index(4);
  const Vec3 from = point_near(bytes, body);
  Ray ray = kind % 2 ? segment(from, point_near(bytes, body)) : Ray{from, bytes.point()};
  if (kind == 3) {
    ray.t_min = bytes.coordinate();
    ray.t_max = bytes.coordinate();
  } else if (kind == 1) {
    ray.t_max = std::numeric_limits<float>::infinity();
  }
  return ray;
}

Region make_region(FuzzBytes& bytes, const FuzzedBody& body) {
  const std::uint32_t kind = bytes.index(6);
  const Vec3 p = point_near(bytes, body), q = point_near(bytes, body);
  switch (kind) {
    case 0:
      return box_between(p, q);
    case 1:
      return Sphere{p, bytes.size()};
    case 2:
      return Capsule{p, q, bytes.size()};
    case 3: {
      const std::array<Vec3, 3> axes = {bytes.point(), bytes.point(), bytes.point()};
      return OrientedBox{p, axes, half_extents(bytes)};
    }
    case 4:
      return make_polyhedron(bytes);
    default:
      return HalfSpace{q, bytes.coordinate()};
  }
}

Solid make_solid(FuzzBytes& bytes, const FuzzedBody& body) {
  const std::uint32_t kind = bytes.index(5);
  const Vec3 p = point_near(bytes, body);
  switch (kind) {
    case 0:
      return box_between(p, point_near(bytes, body));
    case 1:
      return Sphere{p, bytes.size()};
    case 2: {
      const Vec3 q = point_near(bytes, body);
      return Capsule{p, q, bytes.size()};
    }
    case 3: {
      const std::array<Vec3, 3> axes = make_axes(bytes);
      return OrientedBox{p, axes, half_extents(bytes)};
    }
    default:
      return HalfSpace{is_zero(p) ? Vec3{0, 1, 0} : p, bytes.coordinate()};
  }
}

std::optional<HeightField> make_field(FuzzBytes& bytes) {
  HeightGrid grid;
  grid.columns = 2 + bytes.index(12);
  grid.rows = 2 + bytes.index(12);
  grid.origin = bytes.point();
  grid.column_spacing = bytes.size();
  grid.row_spacing = bytes.size();
  std::vector<float> heights(std::size_t{grid.columns} * grid.rows);
  for (std::size_t i = 0; i < heights.size() && !bytes.is_empty(); ++i)
    heights[i] = bytes.index(16) == 15 ? NAN : bytes.coordinate();
  grid.heights = heights;
  Result<HeightField> field = build_height_field(grid);
  if (!field) return std::nullopt;
  return *std::move(field);
}

}  // namespace pelt::test
