#include "scenes/name_index.hpp"

#include "scenes/names.hpp"

#include <algorithm>
#include <utility>

namespace pelt::scenes {

bool matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0;
  std::size_t star = std::string_view::npos, after_star = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      after_star = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      // Extend the match of the last star by one character; earlier stars need not change.
      p = star + 1;
      t = ++after_star;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

NameIndex::NameIndex(const Character& character) {
  add(character.name, part_names(character.asset));
  part_count_ = static_cast<std::uint32_t>(entries_.size() / 2);
  add(character.name, joint_names(character.asset));
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
}

void NameIndex::add(const std::string& model, std::span<const std::string> names) {
  for (const std::string& name : names) {
    const auto number = static_cast<std::uint32_t>(entries_.size() / 2);
    entries_.push_back({name, number});
    std::string full = model;
    full.append("/").append(name);
    entries_.push_back({std::move(full), number});
  }
}

std::vector<std::uint32_t> NameIndex::find(std::string_view pattern) const {
  std::vector<std::uint32_t> found;
  for (const Entry& entry : range_of(pattern))
    if (matches(pattern, entry.name)) found.push_back(entry.number);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::span<const NameIndex::Entry> NameIndex::range_of(std::string_view pattern) const {
  const std::size_t star = pattern.find('*');
  const std::string_view beginning = pattern.substr(0, star);
  const auto first =
      std::lower_bound(entries_.begin(), entries_.end(), beginning,
                       [](const Entry& entry, std::string_view text) { return entry.name < text; });
  const auto last = std::partition_point(first, entries_.end(), [&](const Entry& entry) {
    return star == pattern.npos ? entry.name == pattern : entry.name.starts_with(beginning);
  });
  return std::span(entries_).subspan(static_cast<std::size_t>(first - entries_.begin()),
                                     static_cast<std::size_t>(last - first));
}

}  // namespace pelt::scenes
