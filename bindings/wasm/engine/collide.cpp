/// Two poses: their contacts, on demand and eagerly, and their distance.

#include <pelt/distance.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "model/model.hpp"
#include "pose/pose.hpp"

namespace pelt::wasm {
namespace {

std::vector<Contact>& found() {
  static std::vector<Contact> found;
  return found;
}

/// Gives the eager pose what the other one has, and skins all of it.
QueryStats refit_all(PoseHandle& handle) {
  const detail::Palette& palette = handle.pose.detail().palette;
  if (!handle.eager) handle.eager.emplace(handle.pose.model().detail().tree);
  rivals::ExactPose& eager = *handle.eager;
  if (!handle.morphs.empty()) (void)eager.set_morph_weights(palette.morphs().all());
  (void)eager.set_palette(palette.joints());
  handle.is_refitted = true;
  return eager.open_all();
}

/// As the characters number their triangles.
void answer_contacts(const PoseHandle& a, const PoseHandle& b) {
  for (Contact& contact : found()) {
    contact.triangle_a += a.body.first_triangle;
    contact.triangle_b += b.body.first_triangle;
  }
  answer_data<Contact>(found());
}

void answer_point(std::size_t at, const SurfacePoint& point, const PoseHandle& handle) {
  answer().numbers[at] = static_cast<double>(handle.body.first_triangle) + point.triangle;
  answer().numbers[at + 1] = point.position.x;
  answer().numbers[at + 2] = point.position.y;
  answer().numbers[at + 3] = point.position.z;
}

}  // namespace

PELT_EXPORT void pelt_collide(PoseHandle* a, PoseHandle* b, std::uint32_t most) {
  found().clear();
  answer_stats(collide(a->pose, b->pose, scratch(), found(), {most}));
  answer_contacts(*a, *b);
}

PELT_EXPORT void pelt_refit_all(PoseHandle* handle) { answer_stats(refit_all(*handle)); }

PELT_EXPORT void pelt_collide_eagerly(PoseHandle* a, PoseHandle* b, std::uint32_t most) {
  found().clear();
  QueryStats stats;
  for (PoseHandle* handle : {a, b})
    if (!handle->is_refitted) stats += refit_all(*handle);
  stats += rivals::collide(*a->eager, *b->eager, scratch().detail(), found(), {most});
  answer_stats(stats);
  answer_contacts(*a, *b);
}

PELT_EXPORT std::uint32_t pelt_intersects(PoseHandle* a, PoseHandle* b) {
  return intersects(a->pose, b->pose, scratch()) ? 1 : 0;
}

/// The stats, then the distance and the two points.
PELT_EXPORT std::uint32_t pelt_distance(PoseHandle* a, PoseHandle* b, double most) {
  Distance nearest;
  DistanceOptions options;
  options.max_distance = most;
  answer_stats(distance(a->pose, b->pose, scratch(), nearest, options));
  answer().numbers[6] = nearest.distance;
  answer_point(7, nearest.a, *a);
  answer_point(11, nearest.b, *b);
  return nearest.found() ? 1 : 0;
}

}  // namespace pelt::wasm
