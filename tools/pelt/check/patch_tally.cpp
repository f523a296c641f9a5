#include "tools/pelt/check/patch_tally.hpp"

#include "asset/printable.hpp"
#include "scenes/names.hpp"

#include <algorithm>

namespace pelt::tools::check {

std::vector<DescribedPatch> described_patches(const scene::FrameContacts& found,
                                              const ContactDetails& details) {
  std::vector<DescribedPatch> patches;
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const scene::FrameContacts::Pair& pair = found.pairs[i];
    for (const ContactPatch& patch : details.of_pair(i).patches)
      patches.push_back({pair.a, pair.b, patch.joint_a, patch.joint_b, patch.length});
  }
  return patches;
}

void PatchTally::add(std::uint32_t frame, std::span<const DescribedPatch> patches) {
  patches_ += patches.size();
  for (const DescribedPatch& patch : patches) {
    Longest& known = longest_[{Place{patch.a, patch.joint_a}, Place{patch.b, patch.joint_b}}];
    if (patch.length > known.length) known = {patch.length, frame};
  }
}

std::vector<PatchTally::Row> PatchTally::longest() const {
  std::vector<Row> rows;
  for (const auto& [places, known] : longest_)
    rows.push_back({name(places.first), name(places.second), known.length, known.frame});
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.length > b.length; });
  return rows;
}

std::string PatchTally::name(const Place& place) const {
  const scene::Collider& collider = staged_.colliders[place.collider];
  const std::uint32_t character = staged_.scene.instances[collider.instance].character;
  return scene::collider_name(staged_, collider) + " " +
         asset::printable_name(
             scenes::joint_name(staged_.scene.characters[character].asset, place.joint));
}

}  // namespace pelt::tools::check
