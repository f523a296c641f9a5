#pragma once

/// Contacts that do not count: those between parts or joints that match a pair of names.

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

/// The characters that names refer to.
using CharacterSpan = std::span<const Character* const>;

std::vector<const Character*> characters_of(const Scene& scene);

/// Returns an error for a name that matches no part and no joint of the characters. O(names times
/// parts and joints).
Result<void> check_names(CharacterSpan characters, std::span<const NamePair> pairs);

/// Copies what it needs, so characters and pairs need not outlive it.
class IgnoredPairs {
 public:
  /// A body: a character, given by its index in the span of `make`, and a range of its triangles,
  /// numbered as in its asset.
  struct Body {
    std::uint32_t character = 0;
    std::uint32_t first_triangle = 0, triangle_count = 0;

    friend auto operator<=>(const Body&, const Body&) = default;
  };

  IgnoredPairs() = default;  ///< nothing is ignored

  /// Creates the list. Names that match nothing have no effect (see check_names). Returns the
  /// errors of `label_triangles`. O(names times triangles, parts and joints).
  static Result<IgnoredPairs> make(CharacterSpan characters, std::span<const NamePair> pairs);

  bool is_empty() const { return rules_.empty(); }

  /// Whether a contact of two triangles, of one character or of two, is ignored. Triangles are
  /// numbered as in the assets. O(pairs of names).
  bool is_ignored(std::uint32_t character_a, std::uint32_t triangle_a, std::uint32_t character_b,
                  std::uint32_t triangle_b) const;

  /// Whether one pair of names matches all triangles of both bodies. O(pairs of names times
  /// triangles).
  bool are_ignored(const Body& a, const Body& b) const;

  /// Moves the contacts that count to the front, in their order, and returns their number.
  /// `triangle_a` belongs to character `a`.
  std::size_t keep_counted(std::uint32_t character_a, std::uint32_t character_b,
                           std::span<Contact> contacts) const;

 private:
  /// [character][triangle] whether a name matches the triangle.
  using Meant = std::vector<std::vector<bool>>;

  struct Rule {
    Meant a, b;
  };

  std::vector<Rule> rules_;
};

}  // namespace pelt::scenes
