#pragma once

#include <pelt/contact.hpp>

namespace pelt::detail {

/// Adjacency of the triangles of a model. Arrays [T] are indexed by the caller's triangle numbers.
struct Surface {
  explicit Surface(const SkinnedModel& model);

  SkinnedModel model;
  std::vector<Triangle> corners;          // [T] bit-identical vertices have the same number
  std::vector<std::uint16_t> joints;      // [T] see main_joints
  std::vector<std::uint32_t> components;  // one triangle of each connected component
  bool is_closed = false;
};

inline bool is_surface_of(const pelt::Surface& surface, const pelt::Pose& pose) {
  return &surface.model().detail() == &pose.model().detail();
}

}  // namespace pelt::detail
