#include "support/use_model.hpp"

#include "support/require.hpp"

#include <pelt/pelt.hpp>
#include <pelt/pose.hpp>

#include <cmath>

namespace pelt::test {
namespace {

/// Even joints stay, odd joints move slightly.
std::vector<Matrix4> spread_palette(const SkinnedModel& model, float step) {
  std::vector<Matrix4> palette(model.joint_count());
  for (std::size_t j = 1; j < palette.size(); j += 2) palette[j].m[12] = step;
  return palette;
}

void require_finite(const Pose& pose) {
  std::vector<Vec3> positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  for (const Vec3& p : positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "not finite");
}

}  // namespace

bool use_model(const SkinnedModel& model) {
  Pose a(model), b(model);
  if (!a.set_palette(spread_palette(model, 0.1f))) return false;
  if (!b.set_palette(spread_palette(model, -0.2f))) return false;
  if (!a.set_morph_weights(std::vector<float>(model.morph_target_count(), 0.5f))) return false;
  require_finite(a);
  require_finite(b);
  static_cast<void>(check_bounds(a));  // opens every node; forged bounds may be wrong
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts, {.max_contacts = 100'000});
  for (const Contact& contact : contacts)
    require(
        contact.triangle_a < model.triangle_count() && contact.triangle_b < model.triangle_count(),
        "no such triangle");
  return true;
}

}  // namespace pelt::test
