/// Boxes of a level of the tree, for drawing.

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bounds/level_boxes.hpp"
#include "model/model.hpp"

namespace pelt::wasm {

PELT_EXPORT std::uint32_t pelt_node_count(const PoseHandle* handle) {
  return static_cast<std::uint32_t>(handle->pose.model().detail().tree.nodes.size());
}

PELT_EXPORT std::uint32_t pelt_opened_node_count(const PoseHandle* handle) {
  return opened_node_count(handle->pose.detail());
}

/// Answers with the boxes, and returns the address of their states.
PELT_EXPORT const detail::BoxState* pelt_node_boxes(PoseHandle* handle, std::uint32_t level) {
  static detail::LevelBoxes found;
  if (!handle->whole) handle->whole.emplace(handle->pose.model());
  copy_with_all_bounds(handle->pose.detail(), handle->whole->detail());
  level_boxes(handle->pose.detail(), handle->whole->detail(), level, found);
  answer_data<float>(found.boxes);
  return found.states.data();
}

}  // namespace pelt::wasm
