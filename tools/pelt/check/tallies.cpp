#include "tools/pelt/check/tallies.hpp"

#include "scenes/names.hpp"
#include "text/printable.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools::check {
namespace {

/// The largest number of poses from which a pair of triangles may be absent that is in at least
/// `share` of `poses`. Rounds as
/// ContactTally::in_share_of_poses does.
std::size_t misses_in(std::size_t poses, double share) {
  const auto total = static_cast<double>(poses);
  std::size_t misses = poses;
  while (misses > 0 && static_cast<double>(poses - misses) / total < share) --misses;
  return misses;
}

}  // namespace

AlwaysTally::AlwaysTally(const scene::StagedScene& staged, std::size_t frames, double share)
    : staged_(staged),
      characters_(staged.scene.characters.size()),
      found_(staged.scene.instances.size()) {
  std::vector<std::size_t> poses(characters_.size());
  for (const scenes::Instance& instance : staged.scene.instances)
    poses[instance.character] += frames;
  for (std::size_t c = 0; c < characters_.size(); ++c)
    characters_[c].allowed_misses = misses_in(poses[c], share);
}

void AlwaysTally::add(const scene::FrameContacts& found) {
  for (std::vector<Contact>& of_instance : found_) of_instance.clear();
  for (const scene::FrameContacts::Pair& pair : found.pairs) {
    const std::uint32_t instance = staged_.colliders[pair.a].instance;
    if (instance != staged_.colliders[pair.b].instance) continue;
    const std::span<const Contact> contacts = found.of(pair);
    found_[instance].insert(found_[instance].end(), contacts.begin(), contacts.end());
  }
  for (std::size_t i = 0; i < found_.size(); ++i) {
    contacts_ += found_[i].size();
    std::sort(found_[i].begin(), found_[i].end());
    add_pose(found_[i], characters_[staged_.scene.instances[i].character]);
  }
}

void AlwaysTally::add_pose(std::span<const Contact> contacts, Character& character) {
  ++character.poses;
  merged_.clear();
  const auto store = [&](const Contact& pair, std::size_t poses) {
    if (character.poses - poses <= character.allowed_misses) merged_.push_back({pair, poses});
  };
  auto known = character.counts.begin();
  const auto end = character.counts.end();
  for (const Contact& contact : contacts) {
    for (; known != end && known->pair < contact; ++known) store(known->pair, known->poses);
    const bool is_known = known != end && known->pair == contact;
    store(contact, is_known ? (known++)->poses + 1 : 1);
  }
  for (; known != end; ++known) store(known->pair, known->poses);
  std::swap(character.counts, merged_);
}

AlwaysCounts AlwaysTally::counts() const {
  AlwaysCounts sums = {contacts_, 0};
  for (const Character& character : characters_)
    for (const Count& count : character.counts) sums.always += count.poses;
  return sums;
}

void InsideTally::add(std::uint32_t frame, std::span<const InsidePair> pairs, std::uint32_t take) {
  if (take != take_) held_at_.clear();
  take_ = take;
  bool is_held = false;
  for (const InsidePair& pair : pairs) {
    is_held |= pair.containment != Containment::none;
    if (pair.containment == Containment::a_in_b) add_held(pair.a, pair.b, frame);
    if (pair.containment == Containment::b_in_a) add_held(pair.b, pair.a, frame);
    if (pair.a_in_b.depth > deepest.depth) deepest = {pair.a_in_b.depth, pair.a, pair.b, frame};
    if (pair.b_in_a.depth > deepest.depth) deepest = {pair.b_in_a.depth, pair.b, pair.a, frame};
  }
  if (is_held) frames_held.push_back(frame);
}

void InsideTally::add_held(std::uint32_t inner, std::uint32_t outer, std::uint32_t frame) {
  const std::uint64_t key = std::uint64_t{inner} << 32 | outer;
  const auto [known, is_new] = held_at_.try_emplace(key, held.size());
  if (is_new)
    held.push_back({inner, outer, 1, frame, take_});
  else
    ++held[known->second].frames;
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
         text::printable_name(
             scenes::joint_name(staged_.scene.characters[character].asset, place.joint));
}

}  // namespace pelt::tools::check
