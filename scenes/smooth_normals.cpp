#include "scenes/smooth_normals.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::scenes {
namespace {

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void add(Vec3& sum, const Vec3& v) { sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z}; }

Vec3 unit(const Vec3& v) {
  const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  if (!(length > 0)) return {0, 1, 0};
  return {v.x / length, v.y / length, v.z / length};
}

}  // namespace

void smooth_normals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                    std::span<const std::uint32_t> seams, std::span<Vec3> normals) {
  std::fill(normals.begin(), normals.end(), Vec3{});
  for (const Triangle& t : triangles) {
    const Vec3& a = positions[t[0]];
    const Vec3 twice_area = cross(minus(positions[t[1]], a), minus(positions[t[2]], a));
    for (const std::uint32_t v : t) add(normals[seams[v]], twice_area);
  }
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (seams[v] == v) normals[v] = unit(normals[v]);
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = normals[seams[v]];
}

}  // namespace pelt::scenes
