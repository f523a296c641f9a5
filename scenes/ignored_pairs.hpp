#pragma once

/// Contacts that do not count: those of parts and joints that a scene or its user names.

#include <pelt/collide.hpp>

#include "scenes/scene.hpp"
#include "scenes/triangle_labels.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace pelt::scenes {

/// Those that names may mean.
using CharacterSpan = std::span<const Character* const>;

std::vector<const Character*> characters_of(const Scene& scene);

/// Refuses a name that no part and no joint of the characters has. O(names times parts and
/// joints).
Result<void> check_names(CharacterSpan characters, std::span<const NamePair> pairs);

/// Owns all that it needs: characters and pairs may go.
class IgnoredPairs {
 public:
  /// A character by its place in `make`'s span, and the triangles of it that a body has, numbered
  /// as in its asset.
  struct Body {
    std::uint32_t character = 0;
    std::uint32_t first_triangle = 0, triangle_count = 0;

    friend auto operator<=>(const Body&, const Body&) = default;
  };

  IgnoredPairs() = default;  ///< nothing is ignored

  /// A name that nothing has means nothing (see check_names). Refuses what `label_triangles`
  /// refuses. O(names times triangles, parts and joints).
  static Result<IgnoredPairs> make(CharacterSpan characters, std::span<const NamePair> pairs);

  bool is_empty() const { return rules_.empty(); }

  /// Whether a contact of a triangle of one character with one of another, or of the same, is
  /// ignored; triangles are numbered as in the assets. O(pairs of names).
  bool is_ignored(std::uint32_t character_a, std::uint32_t triangle_a, std::uint32_t character_b,
                  std::uint32_t triangle_b) const;

  /// Whether one pair of names means all triangles of both bodies. O(pairs of names times
  /// triangles).
  bool are_ignored(const Body& a, const Body& b) const;

  /// Moves those of the contacts that count to the front, in their order; returns how many these
  /// are. `triangle_a` is of character `a`.
  std::size_t keep_counted(std::uint32_t character_a, std::uint32_t character_b,
                           std::span<Contact> contacts) const;

 private:
  /// [character][triangle] whether a name means it.
  using Meant = std::vector<std::vector<bool>>;

  struct Rule {
    Meant a, b;
  };

  std::vector<Rule> rules_;
};

}  // namespace pelt::scenes
