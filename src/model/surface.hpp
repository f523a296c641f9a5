#pragma once

#include <pelt/surface.hpp>

#include <memory>
#include <mutex>

namespace pelt::detail {

struct WindingSpread;

/// Adjacency of the triangles of a model. Arrays [T] are indexed by the caller's triangle numbers.
struct Surface {
  explicit Surface(const SkinnedModel& model);

  SkinnedModel model;
  std::vector<Triangle> corners;          // [T] bit-identical vertices have the same number
  std::vector<std::uint16_t> joints;      // [T] see main_joints
  std::vector<std::uint32_t> components;  // one triangle of each connected component
  bool is_closed = false;

  // Made by the first query that needs it (volume/surface_winding.hpp).
  mutable std::once_flag spread_is_made;
  mutable std::shared_ptr<const WindingSpread> spread;
};

/// Such triangles have no area in any pose. Closed surfaces ignore them.
inline bool has_repeated_vertex(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

inline bool is_surface_of(const pelt::Surface& surface, const pelt::Pose& pose) {
  return &surface.model().detail() == &pose.model().detail();
}

}  // namespace pelt::detail
