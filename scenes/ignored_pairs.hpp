#pragma once

/// Contacts that do not count: those between parts or joints that match a pair of names.

#include <pelt/collide.hpp>

#include "scenes/scene.hpp"
#include "scenes/triangle_labels.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// The characters that names refer to.
using CharacterSpan = std::span<const Character* const>;

std::vector<const Character*> characters_of(const Scene& scene);

/// Returns an error for a name that matches no part and no joint of the characters. O(n log n) for
/// n names, of pairs and of characters, and the names that start like a pattern with a star.
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
  /// errors of `label_triangles`. Cost: as of `check_names`, and O(triangles).
  static Result<IgnoredPairs> make(CharacterSpan characters, std::span<const NamePair> pairs);

  bool is_empty() const { return partners_.empty(); }

  /// Whether a contact of two triangles, of one character or of two, is ignored. Triangles are
  /// numbered as in the assets. Cost: O(names that match them), and for each of these a search
  /// among its pairs.
  bool is_ignored(std::uint32_t character_a, std::uint32_t triangle_a, std::uint32_t character_b,
                  std::uint32_t triangle_b) const;

  /// Whether one pair of names matches all triangles of both bodies. O(triangles and names that
  /// match them).
  bool are_ignored(const Body& a, const Body& b) const;

  /// Moves the contacts that count to the front, in their order, and returns their number.
  /// `triangle_a` belongs to character `a`.
  std::size_t keep_counted(std::uint32_t character_a, std::uint32_t character_b,
                           std::span<Contact> contacts) const;

 private:
  /// Indices of distinct names, ascending.
  using NameList = std::vector<std::uint32_t>;

  void add_labels(const TriangleLabels& labels, std::uint32_t part_count,
                  std::span<const NameList> names_of);
  const NameList& names_of(std::uint32_t character, std::uint32_t triangle) const;
  NameList names_of(const Body& body) const;
  bool are_paired(const NameList& a, const NameList& b) const;

  std::vector<NameList> partners_;  // [name] the names that it is paired with
  std::vector<NameList> names_;     // [label] the names that match; a label is a part and a joint
  std::vector<std::vector<std::uint32_t>> labels_;  // [character][triangle]
};

}  // namespace pelt::scenes
