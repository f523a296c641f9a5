#include "bindings/wasm/engine/normals.hpp"

#include <pelt/contact.hpp>

#include "contact/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pelt::wasm {
namespace {

Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

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

std::vector<std::uint32_t> find_seams(const Surface& surface, std::span<const Triangle> triangles,
                                      std::uint32_t vertex_count) {
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> first(vertex_count, kNone);  // by the surface's number of a vertex
  std::vector<std::uint32_t> seams(vertex_count);
  std::iota(seams.begin(), seams.end(), 0u);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& known = first[surface.detail().corners[t][c]];
      if (known == kNone) known = triangles[t][c];
      seams[triangles[t][c]] = known;
    }
  return seams;
}

void smooth_normals(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                    std::span<const std::uint32_t> seams, std::span<Vec3> normals) {
  std::fill(normals.begin(), normals.end(), Vec3{});
  for (const Triangle& t : triangles) {
    const Vec3& a = vertices[t[0]];
    const Vec3 twice_area = cross(vertices[t[1]] - a, vertices[t[2]] - a);
    for (const std::uint32_t v : t) add(normals[seams[v]], twice_area);
  }
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (seams[v] == v) normals[v] = unit(normals[v]);
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = normals[seams[v]];
}

}  // namespace pelt::wasm
