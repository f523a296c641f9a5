#pragma once

/// Names of a scene that patterns select.

#include "scenes/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::scenes {

/// Whether `text` matches `pattern`, in which a `*` matches any number of characters. O(length of
/// `text` times length of `pattern`) in the worst case.
bool matches(std::string_view pattern, std::string_view text);

/// The names of a character's parts and joints, sorted, to find those that match a pattern.
class NameIndex {
 public:
  /// Copies the names. O(n log n) for n names.
  explicit NameIndex(const Character& character);

  /// Returns the matching parts and joints, ascending: part p has the number p, and joint j has the
  /// number of parts plus j. A pattern matches a name alone, as in "cape", or with the model, as in
  /// "knight/cape". O(log n + candidates).
  std::vector<std::uint32_t> find(std::string_view pattern) const;

  /// Returns the number of names that `find` compares with the pattern: those that are equal to it,
  /// or those that start like a pattern with a star.
  std::size_t candidates(std::string_view pattern) const { return range_of(pattern).size(); }

  std::uint32_t part_count() const { return part_count_; }

 private:
  struct Entry {
    std::string name;
    std::uint32_t number;
  };

  void add(const std::string& model, std::span<const std::string> names);
  std::span<const Entry> range_of(std::string_view pattern) const;

  std::uint32_t part_count_ = 0;
  std::vector<Entry> entries_;  // by name; each thing twice, without and with its model
};

}  // namespace pelt::scenes
