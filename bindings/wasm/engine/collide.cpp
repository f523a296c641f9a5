/// Queries of two poses: contacts, on demand and eagerly, and pairs within a tolerance.

#include <pelt/distance.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "collide/eager.hpp"
#include "model/model.hpp"
#include "pose/pose.hpp"

namespace pelt::wasm {
namespace {

std::vector<Contact>& found() {
  static std::vector<Contact> found;
  return found;
}

/// Copies the pose to the eager pose, and skins all of it.
QueryStats open_all(PoseHandle& handle) {
  if (!handle.eager) handle.eager.emplace(handle.pose.model().detail().tree);
  handle.eager->copy(handle.pose.detail());
  handle.is_refitted = true;
  return handle.eager->open_all();
}

/// Converts to the characters' triangle numbers.
void answer_contacts(const PoseHandle& a, const PoseHandle& b) {
  for (Contact& contact : found()) {
    contact.triangle_a += a.body.first_triangle;
    contact.triangle_b += b.body.first_triangle;
  }
  answer_data<Contact>(found());
}

}  // namespace

PELT_EXPORT void pelt_collide(PoseHandle* a, PoseHandle* b, std::uint32_t most) {
  found().clear();
  answer_stats(collide(a->pose, b->pose, scratch(), found(), {most}));
  answer_contacts(*a, *b);
}

PELT_EXPORT void pelt_open_all(PoseHandle* handle) { answer_stats(open_all(*handle)); }

PELT_EXPORT void pelt_collide_eagerly(PoseHandle* a, PoseHandle* b, std::uint32_t most) {
  found().clear();
  QueryStats stats;
  for (PoseHandle* handle : {a, b})
    if (!handle->is_refitted) stats += open_all(*handle);
  stats += detail::collide(*a->eager, *b->eager, scratch().detail(), found(), {most});
  answer_stats(stats);
  answer_contacts(*a, *b);
}

PELT_EXPORT std::uint32_t pelt_intersects(PoseHandle* a, PoseHandle* b) {
  return answer_yes_no(intersects(a->pose, b->pose, scratch()));
}

PELT_EXPORT void pelt_clearance(PoseHandle* a, PoseHandle* b, double tolerance,
                                std::uint32_t most) {
  found().clear();
  answer_stats(clearance(a->pose, b->pose, tolerance, scratch(), found(), {most}));
  answer_contacts(*a, *b);
}

PELT_EXPORT std::uint32_t pelt_is_within(PoseHandle* a, PoseHandle* b, double tolerance) {
  return answer_yes_no(is_within(a->pose, b->pose, tolerance, scratch()));
}

}  // namespace pelt::wasm
