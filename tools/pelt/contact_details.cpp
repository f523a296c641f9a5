#include "tools/pelt/contact_details.hpp"

#include <map>

namespace pelt::tools {
namespace {

std::vector<Surface> make_surfaces(const scenes::Scene& scene,
                                   std::span<const Collider> colliders) {
  std::map<std::pair<std::uint32_t, std::optional<std::uint32_t>>, Surface> by_model;
  std::vector<Surface> surfaces;
  for (const Collider& collider : colliders) {
    const std::uint32_t character = scene.instances[collider.instance].character;
    const auto key = std::make_pair(character, collider.part);
    surfaces.push_back(by_model.try_emplace(key, collider.model).first->second);
  }
  return surfaces;
}

}  // namespace

ContactDetails::ContactDetails(const scenes::Scene& scene, std::span<const Collider> colliders)
    : colliders_(colliders), surfaces_(make_surfaces(scene, colliders)), posed_(colliders) {}

Result<void> ContactDetails::describe(const Palettes& palettes, const FrameContacts& found) {
  if (found.pairs.empty()) return {};
  if (const Result<void> taken = posed_.set_palettes(palettes); !taken) return taken;
  if (geometry_.size() < found.pairs.size()) geometry_.resize(found.pairs.size());
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const std::uint32_t a = found.pairs[i].a, b = found.pairs[i].b;
    contacts_.clear();
    for (const Contact& contact : found.of(found.pairs[i])) {
      contacts_.push_back({contact.triangle_a - colliders_[a].first_triangle,
                           contact.triangle_b - colliders_[b].first_triangle});
    }
    describe_contacts(posed_.poses()[a], surfaces_[a], posed_.poses()[b], surfaces_[b], contacts_,
                      geometry_[i]);
  }
  return {};
}

}  // namespace pelt::tools
