#include "tools/pelt/bench/anytime_runner.hpp"

namespace pelt::tools::bench {

AnytimeBenchMethod anytime_method_of(const methods::AnytimeMethodKind& kind) {
  return {std::string(kind.name), std::string(kind.title), kind.make};
}

AnytimeRunner::AnytimeRunner(std::span<const scene::Collider> colliders,
                             const AnytimeBenchMethod& method)
    : colliders_(colliders), method_(method.make()) {
  for (const scene::Collider& collider : colliders_) method_->add(collider.model);
}

Result<void> AnytimeRunner::start(const AnytimeCase& of, const scene::Palettes& palettes) {
  method_->select(of.a, of.b);
  Result<void> posed = pose(of, palettes);
  if (posed) method_->restart();
  return posed;
}

Result<void> AnytimeRunner::pose(const AnytimeCase& of, const scene::Palettes& palettes) {
  for (const std::uint32_t body : {of.a, of.b}) {
    const auto posed =
        scene::set_pose(selection_.select(palettes, colliders_[body]), *method_, body);
    if (!posed) return scene::in_instance(colliders_[body].instance, posed.error());
  }
  return {};
}

}  // namespace pelt::tools::bench
