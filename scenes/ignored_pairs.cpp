#include "scenes/ignored_pairs.hpp"

#include "scenes/name_index.hpp"
#include "scenes/names.hpp"
#include "text/message.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace pelt::scenes {
namespace {

/// Returns all names, each once, in their order; with their models if `with_models`.
std::vector<std::string> all_names(CharacterSpan characters, bool with_models) {
  std::vector<std::string> all;
  std::unordered_set<std::string> known;
  for (const Character* character : characters) {
    const std::string prefix = with_models ? character->name + "/" : "";
    for (const auto& list : {part_names(character->asset), joint_names(character->asset)}) {
      for (const std::string& bare : list) {
        const std::string name = prefix + bare;
        if (known.insert(name).second) all.push_back(name);
      }
    }
  }
  return all;
}

Error unknown_name(CharacterSpan characters, std::string_view name) {
  const bool with_models = name.find('/') != name.npos;
  const std::vector<std::string> names = all_names(characters, with_models);
  const std::vector<std::string_view> known(names.begin(), names.end());
  return {ErrorCode::invalid_argument,
          "no part and no joint is named " + text::quoted(name) + text::suggestion(name, known)};
}

/// The distinct names of all pairs.
class NameNumbers {
 public:
  std::uint32_t number_of(std::string_view name) {
    const auto [known, is_new] =
        numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) names_.push_back(name);
    return known->second;
  }

  std::span<const std::string_view> names() const { return names_; }

 private:
  std::unordered_map<std::string_view, std::uint32_t> numbers_;
  std::vector<std::string_view> names_;
};

void sort_unique(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Whether two ascending lists have a common element. O(shorter list times log of the longer one).
bool have_common(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  if (a.size() > b.size()) std::swap(a, b);
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t element) {
    return std::binary_search(b.begin(), b.end(), element);
  });
}

/// Returns for each part and joint the numbers of the names that match it.
std::vector<std::vector<std::uint32_t>> matching_names(const NameIndex& index, std::size_t size,
                                                       std::span<const std::string_view> names) {
  std::vector<std::vector<std::uint32_t>> matching(size);
  for (std::uint32_t n = 0; n < names.size(); ++n)
    for (const std::uint32_t thing : index.find(names[n])) matching[thing].push_back(n);
  return matching;
}

}  // namespace

std::vector<const Character*> characters_of(const Scene& scene) {
  std::vector<const Character*> characters;
  for (const Character& character : scene.characters) characters.push_back(&character);
  return characters;
}

Result<void> check_names(CharacterSpan characters, std::span<const NamePair> pairs) {
  if (pairs.empty()) return {};
  std::vector<NameIndex> indices;
  for (const Character* character : characters) indices.emplace_back(*character);
  const auto has = [&](const std::string& pattern) {
    return std::any_of(indices.begin(), indices.end(),
                       [&](const NameIndex& index) { return !index.find(pattern).empty(); });
  };
  for (const NamePair& pair : pairs) {
    if (!has(pair.a)) return unknown_name(characters, pair.a);
    if (!has(pair.b)) return unknown_name(characters, pair.b);
  }
  return {};
}

Result<IgnoredPairs> IgnoredPairs::make(CharacterSpan characters, std::span<const NamePair> pairs) {
  IgnoredPairs ignored;
  if (pairs.empty()) return ignored;
  NameNumbers numbers;
  ignored.partners_.resize(2 * pairs.size());
  for (const NamePair& pair : pairs) {
    const std::uint32_t a = numbers.number_of(pair.a), b = numbers.number_of(pair.b);
    ignored.partners_[a].push_back(b);
    ignored.partners_[b].push_back(a);
  }
  ignored.partners_.resize(numbers.names().size());
  for (NameList& partners : ignored.partners_) sort_unique(partners);
  for (const Character* character : characters) {
    const Result<TriangleLabels> labels = label_triangles(character->asset);
    if (!labels) return text::prefixed(character->source, labels.error());
    const NameIndex index(*character);
    const std::size_t size = index.part_count() + character->asset.joints.size();
    ignored.add_labels(*labels, index.part_count(), matching_names(index, size, numbers.names()));
  }
  return ignored;
}

/// `names_of`: the names that match each part, and then each joint.
void IgnoredPairs::add_labels(const TriangleLabels& triangles, std::uint32_t part_count,
                              std::span<const NameList> names_of) {
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  std::vector<std::uint32_t>& labels = labels_.emplace_back();
  for (std::size_t t = 0; t < triangles.part.size(); ++t) {
    const std::uint32_t part = triangles.part[t], joint = part_count + triangles.joint[t];
    const auto [label, is_new] = known.try_emplace(std::uint64_t{part} << 32 | joint,
                                                   static_cast<std::uint32_t>(names_.size()));
    labels.push_back(label->second);
    if (!is_new) continue;
    NameList& names = names_.emplace_back();
    std::set_union(names_of[part].begin(), names_of[part].end(), names_of[joint].begin(),
                   names_of[joint].end(), std::back_inserter(names));
  }
}

const IgnoredPairs::NameList& IgnoredPairs::names_of(std::uint32_t character,
                                                     std::uint32_t triangle) const {
  return names_[labels_[character][triangle]];
}

/// Returns the names that match all triangles of a body.
IgnoredPairs::NameList IgnoredPairs::names_of(const Body& body) const {
  const auto labels =
      std::span(labels_[body.character]).subspan(body.first_triangle, body.triangle_count);
  if (labels.empty()) return {};
  NameList common = names_[labels[0]];
  for (std::size_t t = 1; t < labels.size() && !common.empty(); ++t) {
    if (labels[t] == labels[t - 1]) continue;
    const NameList& others = names_[labels[t]];
    NameList both;
    std::set_intersection(common.begin(), common.end(), others.begin(), others.end(),
                          std::back_inserter(both));
    common = std::move(both);
  }
  return common;
}

bool IgnoredPairs::are_paired(const NameList& a, const NameList& b) const {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t name) { return have_common(partners_[name], b); });
}

bool IgnoredPairs::is_ignored(std::uint32_t character_a, std::uint32_t triangle_a,
                              std::uint32_t character_b, std::uint32_t triangle_b) const {
  return !is_empty() &&
         are_paired(names_of(character_a, triangle_a), names_of(character_b, triangle_b));
}

bool IgnoredPairs::are_ignored(const Body& a, const Body& b) const {
  return !is_empty() && are_paired(names_of(a), names_of(b));
}

std::size_t IgnoredPairs::keep_counted(std::uint32_t character_a, std::uint32_t character_b,
                                       std::span<Contact> contacts) const {
  const auto ignored = [&](const Contact& contact) {
    return is_ignored(character_a, contact.triangle_a, character_b, contact.triangle_b);
  };
  const auto end = std::remove_if(contacts.begin(), contacts.end(), ignored);
  return static_cast<std::size_t>(end - contacts.begin());
}

}  // namespace pelt::scenes
