#pragma once

/// The surface of a model: which triangles adjoin.

#include <pelt/surface.hpp>

#include "model/model.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

struct WindingSpread;

/// Adjacency of the triangles of a model. Arrays [T] are indexed by the caller's triangle numbers.
struct Surface {
  explicit Surface(const Model& model);

  const Model& model;                     // owns this surface
  std::vector<Triangle> corners;          // [T] bit-identical vertices have the same number
  std::vector<std::uint16_t> joints;      // [T] see main_joints
  std::vector<std::uint32_t> components;  // one triangle of each connected component
  bool is_closed = false;

  MadeOnce<WindingSpread> lazy_spread;  // see volume/surface_winding.hpp
};

/// Whether two corners of a triangle are one vertex. Such a triangle has no area in any pose.
/// Closed surfaces ignore it.
inline bool has_repeated_vertex(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

inline const Surface& surface_of(const pelt::Pose& pose) { return pose.model().detail().surface(); }

}  // namespace pelt::detail
