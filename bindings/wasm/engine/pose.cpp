/// Poses, and queries of a single pose.

#include <pelt/bounds.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "scenes/smooth_normals.hpp"

namespace pelt::wasm {
namespace {

void answer_bounds(const Bounds& bounds) {
  answer_box(bounds.box);
  answer().centre = numbers_of(bounds.sphere.centre);
  answer().radius = bounds.sphere.radius;
}

/// Skins the vertices unless that is already done. Drawing needs vertices and then normals.
std::span<const Vec3> pose_vertices(PoseHandle& handle) {
  if (handle.has_vertices) return handle.vertices;
  handle.vertices.resize(handle.pose.model().vertex_count());
  posed_vertices(handle.pose, handle.vertices);
  handle.has_vertices = true;
  return handle.vertices;
}

}  // namespace

/// Creates a pose of a part or of the whole character.
PELT_EXPORT std::uint32_t pelt_make_pose(const CharacterHandle* handle, std::uint32_t part) {
  const Result<Body*> body = handle->character->body(part);
  if (!body) return refuse(body.error());
  return address_of(new PoseHandle(handle->character, **body));
}

PELT_EXPORT void pelt_delete_pose(PoseHandle* handle) { delete handle; }

/// Returns memory where JavaScript writes a palette or weights.
PELT_EXPORT float* pelt_pose_palette(PoseHandle* handle) { return handle->palette[0].m.data(); }
PELT_EXPORT float* pelt_pose_weights(PoseHandle* handle) { return handle->morphs.data(); }

PELT_EXPORT std::uint32_t pelt_set_palette(PoseHandle* handle) {
  handle->moved();
  return done(handle->pose.set_palette(handle->palette));
}

/// JavaScript writes eight floats per joint to the memory of the palette.
PELT_EXPORT std::uint32_t pelt_set_dual_quaternions(PoseHandle* handle) {
  handle->moved();
  const std::size_t count = 8 * handle->palette.size();
  return done(handle->pose.set_dual_quaternions({handle->palette[0].m.data(), count}));
}

PELT_EXPORT std::uint32_t pelt_set_morph_weights(PoseHandle* handle) {
  handle->moved();
  return done(handle->pose.set_morph_weights(handle->morphs));
}

/// Returns memory where JavaScript writes the positions of all vertices.
PELT_EXPORT float* pelt_given_vertices(PoseHandle* handle) {
  handle->has_vertices = false;
  handle->vertices.resize(handle->pose.model().vertex_count());
  return &handle->vertices.data()->x;
}

PELT_EXPORT std::uint32_t pelt_set_vertices(PoseHandle* handle) {
  handle->moved();
  const Result<void> set = handle->pose.set_vertices(handle->vertices);
  handle->has_vertices = static_cast<bool>(set);
  return done(set);
}

/// Returns memory where JavaScript writes the offsets of all vertices. The pose may borrow this
/// memory already, so call pelt_set_offsets before the next query.
PELT_EXPORT float* pelt_pose_offsets(PoseHandle* handle) {
  handle->offsets.resize(handle->pose.model().vertex_count());
  return &handle->offsets.data()->x;
}

PELT_EXPORT std::uint32_t pelt_set_offsets(PoseHandle* handle) {
  handle->moved();
  return done(handle->pose.set_offsets(handle->offsets));
}

PELT_EXPORT std::uint32_t pelt_remove_offsets(PoseHandle* handle) {
  handle->moved();
  return done(handle->pose.set_offsets({}));
}

PELT_EXPORT std::uint32_t pelt_check_offsets(const PoseHandle* handle) {
  return check_offsets(handle->pose);
}

PELT_EXPORT void pelt_posed_vertices(PoseHandle* handle) {
  answer_data<Vec3>(pose_vertices(*handle));
}

PELT_EXPORT void pelt_normals(PoseHandle* handle) {
  pose_vertices(*handle);
  Character& character = *handle->character;
  handle->normals.resize(handle->vertices.size());
  scenes::smooth_normals(handle->vertices, character.asset().triangles, character.get_seams(),
                         handle->normals);
  answer_data<Vec3>(handle->normals);
}

PELT_EXPORT void pelt_bounds(PoseHandle* handle, std::uint32_t levels) {
  Bounds found;
  answer_stats(bounds(handle->pose, found, levels));
  answer_bounds(found);
}

PELT_EXPORT void pelt_exact_bounds(PoseHandle* handle) {
  Bounds found;
  answer_stats(exact_bounds(handle->pose, found));
  answer_bounds(found);
}

}  // namespace pelt::wasm
