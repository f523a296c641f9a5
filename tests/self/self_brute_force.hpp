#pragma once

/// The contacts of a pose with itself, by a test of all pairs.

#include <pelt/self.hpp>
#include <pelt/self_filter.hpp>

#include "self/neighbours.hpp"
#include "support/skinned_shapes.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

namespace pelt::test {

using SurfaceTriangles = std::vector<detail::SurfaceTriangle>;

/// Returns for each vertex the number of its surface vertex: vertices with equal rest
/// positions and the same bits in displacements have the same number.
inline std::vector<std::uint32_t> surface_vertices(const SkinnedMeshView& mesh) {
  std::vector<std::vector<std::uint32_t>> keys;
  const auto add_bits = [&](std::size_t vertex, const Vec3& v) {
    for (const float c : {v.x, v.y, v.z}) keys[vertex].push_back(std::bit_cast<std::uint32_t>(c));
  };
  keys.resize(mesh.rest_positions.size());
  for (std::size_t v = 0; v < keys.size(); ++v) {
    const Vec3& p = mesh.rest_positions[v];
    add_bits(v, {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F});  // turns -0.0 into 0.0
  }
  const auto& [begin, vertices, displacements] = mesh.morph_targets;
  for (std::uint32_t m = 0; m + 1 < begin.size(); ++m)
    for (std::uint32_t i = begin[m]; i < begin[m + 1]; ++i) {
      if (displacements[i] == Vec3{}) continue;
      keys[vertices[i]].push_back(m);
      add_bits(vertices[i], displacements[i]);
    }
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;
  std::vector<std::uint32_t> result;
  for (const auto& key : keys)
    result.push_back(
        numbers.emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second);
  return result;
}

inline std::vector<std::uint32_t> surface_vertices(const Shape& shape) {
  return surface_vertices(shape.view());
}

inline SurfaceTriangles posed_triangles(const SkinnedMeshView& mesh,
                                        const std::vector<std::uint32_t>& surface,
                                        const Pose& pose) {
  std::vector<Vec3> positions(mesh.rest_positions.size());
  posed_vertices(pose, positions);
  SurfaceTriangles triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({{positions[t[0]], positions[t[1]], positions[t[2]]},
                         {surface[t[0]], surface[t[1]], surface[t[2]]}});
  return triangles;
}

inline std::vector<Contact> brute_force_self(const SurfaceTriangles& triangles) {
  std::vector<Contact> contacts;
  for (std::uint32_t s = 0; s < triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < triangles.size(); ++t)
      if (detail::surface_triangles_intersect(triangles[s], triangles[t]))
        contacts.push_back({s, t});
  return contacts;
}

inline std::vector<Contact> brute_force_self(const Shape& shape, const Pose& pose) {
  return brute_force_self(posed_triangles(shape.view(), surface_vertices(shape), pose));
}

/// The same for large meshes: tests only pairs whose extents overlap, found by a sweep over y.
inline std::vector<Contact> sweep_self(const SurfaceTriangles& triangles) {
  struct Extent {
    Vec3 low, high;
  };
  std::vector<Extent> extents;
  for (const detail::SurfaceTriangle& t : triangles) {
    const auto& [p, q, r] = t.corners;
    extents.push_back(
        {{std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}), std::min({p.z, q.z, r.z})},
         {std::max({p.x, q.x, r.x}), std::max({p.y, q.y, r.y}), std::max({p.z, q.z, r.z})}});
  }
  std::vector<std::uint32_t> order(triangles.size()), active;
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto s, auto t) { return extents[s].low.y < extents[t].low.y; });
  std::vector<Contact> contacts;
  for (const std::uint32_t s : order) {
    const Extent& a = extents[s];
    std::erase_if(active, [&](std::uint32_t t) { return extents[t].high.y < a.low.y; });
    for (const std::uint32_t t : active) {
      const Extent& b = extents[t];
      if (a.high.x < b.low.x || b.high.x < a.low.x || a.high.z < b.low.z || b.high.z < a.low.z)
        continue;
      if (detail::surface_triangles_intersect(triangles[s], triangles[t]))
        contacts.push_back({std::min(s, t), std::max(s, t)});
    }
    active.push_back(s);
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

inline std::vector<Contact> self_contacts_of(Pose& pose, const SelfFilter& filter,
                                             Scratch& scratch) {
  std::vector<Contact> contacts;
  self_collide(pose, filter, scratch, contacts);
  return contacts;
}

}  // namespace pelt::test
