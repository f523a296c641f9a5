#pragma once

/// The contacts of a pose with itself, by a test of all pairs.

#include "geometry/neighbour_pair.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/self_collide.hpp>

#include <bit>
#include <cstdint>
#include <map>
#include <vector>

namespace pelt::test {

/// Returns for each vertex the number of its surface vertex: vertices with the same bits in rest
/// position and displacements have the same number.
inline std::vector<std::uint32_t> surface_vertices(const Shape& shape) {
  std::vector<std::vector<std::uint32_t>> keys;
  const auto add_bits = [&](std::size_t vertex, const Vec3& v) {
    for (const float c : {v.x, v.y, v.z}) keys[vertex].push_back(std::bit_cast<std::uint32_t>(c));
  };
  keys.resize(shape.rest_positions.size());
  for (std::size_t v = 0; v < keys.size(); ++v) add_bits(v, shape.rest_positions[v]);
  for (std::uint32_t m = 0; m < shape.morph_target_count(); ++m)
    for (std::uint32_t i = shape.morph_begin[m]; i < shape.morph_begin[m + 1]; ++i) {
      if (shape.morph_displacements[i] == Vec3{}) continue;
      keys[shape.morph_vertices[i]].push_back(m);
      add_bits(shape.morph_vertices[i], shape.morph_displacements[i]);
    }
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;
  std::vector<std::uint32_t> result;
  for (const auto& key : keys)
    result.push_back(
        numbers.emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second);
  return result;
}

inline std::vector<Contact> brute_force_self(const Shape& shape, const Pose& pose) {
  std::vector<Vec3> positions(shape.rest_positions.size());
  posed_vertices(pose, positions);
  const std::vector<std::uint32_t> surface = surface_vertices(shape);
  std::vector<detail::SurfaceTriangle> triangles;
  for (const Triangle& t : shape.triangles)
    triangles.push_back({{positions[t[0]], positions[t[1]], positions[t[2]]},
                         {surface[t[0]], surface[t[1]], surface[t[2]]}});
  std::vector<Contact> contacts;
  for (std::uint32_t s = 0; s < triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < triangles.size(); ++t)
      if (detail::surface_triangles_intersect(triangles[s], triangles[t]))
        contacts.push_back({s, t});
  return contacts;
}

inline std::vector<Contact> self_contacts_of(Pose& pose, const SelfFilter& filter,
                                             Scratch& scratch) {
  std::vector<Contact> contacts;
  self_collide(pose, filter, scratch, contacts);
  return contacts;
}

}  // namespace pelt::test
