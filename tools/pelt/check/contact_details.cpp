#include "tools/pelt/check/contact_details.hpp"

#include <utility>

namespace pelt::tools::check {
namespace {

/// Models of parts number only the joints that the part follows.
void number_joints_in_assets(ContactGeometry& geometry, const scene::Collider& a,
                             const scene::Collider& b) {
  const auto renumber = [&](auto& described) {
    described.joint_a = a.joint_in_asset(described.joint_a);
    described.joint_b = b.joint_in_asset(described.joint_b);
  };
  for (ContactTrace& trace : geometry.traces) renumber(trace);
  for (ContactPatch& patch : geometry.patches) renumber(patch);
}

}  // namespace

ContactDetails::ContactDetails(const scene::StagedScene& staged)
    : colliders_(staged.colliders), posed_(staged.colliders) {}

Result<void> ContactDetails::describe(const scene::Palettes& palettes,
                                      const scene::FrameContacts& found) {
  if (found.pairs.empty()) return {};
  if (const Result<void> taken = posed_.set_palettes(palettes); !taken) return taken;
  if (geometry_.size() < found.pairs.size()) geometry_.resize(found.pairs.size());
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const std::uint32_t a = found.pairs[i].a, b = found.pairs[i].b;
    contacts_.clear();
    for (const Contact& contact : found.of(found.pairs[i])) {
      contacts_.push_back(scene::numbered_in_models(contact, colliders_[a], colliders_[b]));
    }
    describe_pair(a, b, geometry_[i]);
    number_joints_in_assets(geometry_[i], colliders_[a], colliders_[b]);
  }
  return {};
}

void ContactDetails::describe_pair(std::uint32_t a, std::uint32_t b, ContactGeometry& geometry) {
  const std::span<Pose> poses = posed_.poses();
  if (a == b)
    describe_contacts(poses[a], contacts_, scratch_, geometry);
  else
    describe_contacts(poses[a], poses[b], contacts_, scratch_, geometry);
}

}  // namespace pelt::tools::check
