#include <pelt/asset.hpp>

#include "base/assert.hpp"

#include <algorithm>

namespace pelt::asset {

SkinnedMeshView Asset::mesh() const {
  return {rest_positions,
          triangles,
          influences_per_vertex,
          joint_indices,
          weights,
          static_cast<std::uint32_t>(joints.size()),
          {morph_begin, morph_vertices, morph_displacements}};
}

const Clip* Asset::find_clip(std::string_view name) const {
  const auto clip = std::find_if(clips.begin(), clips.end(),
                                 [name](const Clip& candidate) { return candidate.name == name; });
  return clip == clips.end() ? nullptr : &*clip;
}

const std::string& Asset::joint_name(std::uint32_t joint) const {
  PELT_ASSERT(joint < joints.size());
  return nodes[joints[joint].node].name;
}

const Part& Asset::part_of(std::uint32_t triangle) const {
  PELT_ASSERT(triangle < triangles.size());
  const auto next = std::upper_bound(
      parts.begin(), parts.end(), triangle,
      [](std::uint32_t value, const Part& part) { return value < part.first_triangle; });
  return *std::prev(next);
}

}  // namespace pelt::asset
