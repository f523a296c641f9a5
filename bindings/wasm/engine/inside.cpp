/// Inside and outside of closed surfaces.

#include <pelt/inside.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/surface_points.hpp"

namespace pelt::wasm {

PELT_EXPORT std::uint32_t pelt_is_closed(PoseHandle* handle) {
  return handle->pose.model().surface().is_closed() ? 1 : 0;
}

/// Returns a PointSide. Precondition: the surface is closed.
PELT_EXPORT std::uint32_t pelt_side_of(PoseHandle* handle, float x, float y, float z) {
  PointSide side = PointSide::outside;
  answer_stats(side_of(handle->pose, {x, y, z}, scratch(), side));
  return static_cast<std::uint32_t>(side);
}

/// The answer is the closest point of b's surface, the stats, the vertex, its position and its
/// depth. Precondition: the surface of b is closed.
PELT_EXPORT std::uint32_t pelt_deepest_vertex(PoseHandle* a, PoseHandle* b) {
  Penetration deepest;
  answer_stats(deepest_vertex(a->pose, b->pose, scratch(), deepest));
  answer().vertex = deepest.vertex;
  answer().position = numbers_of(deepest.position);
  answer().depth = deepest.depth;
  answer_points({{deepest.closest, *b}});
  return deepest ? 1 : 0;
}

/// Returns a Containment.
PELT_EXPORT std::uint32_t pelt_containment(PoseHandle* a, PoseHandle* b) {
  Containment found = Containment::none;
  answer_stats(containment(a->pose, b->pose, scratch(), found));
  return static_cast<std::uint32_t>(found);
}

}  // namespace pelt::wasm
