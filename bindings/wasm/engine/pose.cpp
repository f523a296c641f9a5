/// Poses, their vertices and bounds, and boxes of a level of the tree for drawing.

#include <pelt/bounds.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bounds/level_boxes.hpp"
#include "model/model.hpp"
#include "scenes/smooth_normals.hpp"

namespace pelt::wasm {
namespace {

void answer_bounds(const Bounds& bounds) {
  answer_box(bounds.box);
  answer().centre = numbers_of(bounds.sphere.centre);
  answer().radius = bounds.sphere.radius;
}

/// Skins the vertices unless they are up to date: drawing needs vertices and then normals.
std::span<const Vec3> pose_vertices(PoseHandle& handle) {
  if (handle.has_vertices) return handle.vertices;
  handle.vertices.resize(handle.pose.model().vertex_count());
  posed_vertices(handle.pose, handle.vertices);
  handle.has_vertices = true;
  return handle.vertices;
}

/// Marks the vertices as out of date, and returns the result of a setter of the pose.
Result<void> moved(PoseHandle& handle, const Result<void>& set) {
  handle.moved();
  return in_words_of_javascript(set);
}

}  // namespace

/// Creates a pose of a part or of the whole character.
Result<PoseHandle*> make_pose(const CharacterHandle& handle, std::uint32_t part) {
  const Result<Body*> body = handle.character->body(part);
  if (!body) return body.error();
  return new PoseHandle(handle.character, **body);
}
PELT_EXPORT(make_pose)

void delete_pose(PoseHandle* handle) { delete handle; }
PELT_EXPORT(delete_pose)

template <auto kSet>
Result<void> set_numbers(PoseHandle& handle, std::span<const float> numbers) {
  return moved(handle, (handle.pose.*kSet)(numbers));
}
PELT_EXPORT_AS(set_palette, set_numbers<&Pose::set_palette>)
PELT_EXPORT_AS(set_dual_quaternions, set_numbers<&Pose::set_dual_quaternions>)
PELT_EXPORT_AS(set_morph_weights, set_numbers<&Pose::set_morph_weights>)

Result<void> set_vertices(PoseHandle& handle, std::span<const Vec3> vertices) {
  Result<void> set = moved(handle, handle.pose.set_vertices(vertices));
  if (set) handle.vertices.assign(vertices.begin(), vertices.end());
  handle.has_vertices = static_cast<bool>(set);
  return set;
}
PELT_EXPORT(set_vertices)

/// Without offsets, the pose has none.
Result<void> set_offsets(PoseHandle& handle, std::span<const Vec3> offsets) {
  handle.offsets.assign(offsets.begin(), offsets.end());
  return moved(handle, handle.pose.set_offsets(handle.offsets));
}
PELT_EXPORT(set_offsets)

std::uint32_t check_offsets(const PoseHandle& handle) { return check_offsets(handle.pose); }
PELT_EXPORT(check_offsets)

void posed_vertices(PoseHandle& handle) { answer_arrays(pose_vertices(handle)); }
PELT_EXPORT(posed_vertices)

void normals(PoseHandle& handle) {
  pose_vertices(handle);
  Character& character = *handle.character;
  handle.normals.resize(handle.vertices.size());
  scenes::smooth_normals(handle.vertices, character.asset().triangles, character.get_seams(),
                         handle.normals);
  answer_arrays(handle.normals);
}
PELT_EXPORT(normals)

QueryStats bounds(PoseHandle& handle, std::uint32_t levels) {
  Bounds found;
  const QueryStats stats = bounds(handle.pose, found, levels);
  answer_bounds(found);
  return stats;
}
PELT_EXPORT(bounds)

QueryStats exact_bounds(PoseHandle& handle) {
  Bounds found;
  const QueryStats stats = exact_bounds(handle.pose, found);
  answer_bounds(found);
  return stats;
}
PELT_EXPORT(exact_bounds)

std::uint32_t node_count(const PoseHandle& handle) {
  return static_cast<std::uint32_t>(handle.pose.model().detail().tree.nodes.size());
}
PELT_EXPORT(node_count)

std::uint32_t opened_node_count(const PoseHandle& handle) {
  return opened_node_count(handle.pose.detail());
}
PELT_EXPORT(opened_node_count)

/// Answers with the boxes and their states.
void node_boxes(PoseHandle& handle, std::uint32_t level) {
  static detail::LevelBoxes found;
  if (!handle.whole) handle.whole.emplace(handle.pose.model());
  copy_with_all_bounds(handle.pose.detail(), handle.whole->detail());
  level_boxes(handle.pose.detail(), handle.whole->detail(), level, found);
  answer_arrays(found.boxes, found.states);
}
PELT_EXPORT(node_boxes)

}  // namespace pelt::wasm
