#include "tools/pelt/check/ignored_contacts.hpp"

#include <algorithm>

namespace pelt::tools::check {

std::uint64_t take_ignored_out(const scenes::IgnoredPairs& ignored,
                               const scene::StagedScene& staged, scene::FrameContacts& found) {
  if (ignored.is_empty()) return 0;
  const auto character_of = [&](std::uint32_t collider) {
    return staged.scene.instances[staged.colliders[collider].instance].character;
  };
  const std::size_t before = found.contacts.size();
  std::size_t end = 0;
  for (scene::FrameContacts::Pair& pair : found.pairs) {
    const std::span<Contact> contacts =
        std::span(found.contacts).subspan(pair.begin, pair.end - pair.begin);
    const std::size_t counted =
        ignored.keep_counted(character_of(pair.a), character_of(pair.b), contacts);
    std::copy_n(contacts.begin(), counted,
                found.contacts.begin() + static_cast<std::ptrdiff_t>(end));
    pair.begin = end;
    pair.end = end += counted;
  }
  found.contacts.resize(end);
  std::erase_if(found.pairs, [](const scene::FrameContacts::Pair& p) { return p.begin == p.end; });
  return before - end;
}

}  // namespace pelt::tools::check
