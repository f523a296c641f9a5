#include "scenes/ignored_pairs.hpp"

#include "asset/message.hpp"
#include "scenes/closest_name.hpp"
#include "scenes/name_pattern.hpp"
#include "scenes/names.hpp"

#include <algorithm>
#include <string>
#include <unordered_set>

namespace pelt::scenes {
namespace {

struct Names {
  explicit Names(const Character& character)
      : model(character.name),
        parts(part_names(character.asset)),
        joints(joint_names(character.asset)) {}

  std::string with_model(const std::string& name) const { return model + "/" + name; }

  std::string model;
  std::vector<std::string> parts, joints;
};

/// Parts and joints of a character that a pattern matches.
struct Named {
  std::vector<bool> parts, joints;

  bool is_any() const {
    const auto is_meant = [](bool meant) { return meant; };
    return std::any_of(parts.begin(), parts.end(), is_meant) ||
           std::any_of(joints.begin(), joints.end(), is_meant);
  }
};

Named find_named(std::string_view pattern, const Names& names) {
  const auto is_meant = [&](const std::string& name) {
    return matches(pattern, name) || matches(pattern, names.with_model(name));
  };
  Named named;
  for (const std::string& part : names.parts) named.parts.push_back(is_meant(part));
  for (const std::string& joint : names.joints) named.joints.push_back(is_meant(joint));
  return named;
}

/// Returns all names, each once, in their order; with their models if `with_models`.
std::vector<std::string> all_names(std::span<const Names> characters, bool with_models) {
  std::vector<std::string> all;
  std::unordered_set<std::string> known;
  for (const Names& names : characters) {
    for (const auto* list : {&names.parts, &names.joints}) {
      for (const std::string& bare : *list) {
        const std::string name = with_models ? names.with_model(bare) : bare;
        if (known.insert(name).second) all.push_back(name);
      }
    }
  }
  return all;
}

Error unknown_name(std::span<const Names> characters, std::string_view name) {
  const bool with_models = name.find('/') != name.npos;
  const std::vector<std::string> names = all_names(characters, with_models);
  const std::vector<std::string_view> known(names.begin(), names.end());
  return {ErrorCode::invalid_argument,
          "no part and no joint is named " + asset::quoted(name) + suggestion(name, known)};
}

/// Returns for each triangle whether the pattern matches it.
std::vector<bool> find_meant(std::string_view pattern, const Names& names,
                             const TriangleLabels& labels) {
  const Named named = find_named(pattern, names);
  std::vector<bool> meant;
  for (std::size_t t = 0; t < labels.part.size(); ++t)
    meant.push_back(named.parts[labels.part[t]] || named.joints[labels.joint[t]]);
  return meant;
}

bool are_all_meant(const std::vector<bool>& meant, const IgnoredPairs::Body& body) {
  const auto first = meant.begin() + body.first_triangle;
  return std::find(first, first + body.triangle_count, false) == first + body.triangle_count;
}

}  // namespace

std::vector<const Character*> characters_of(const Scene& scene) {
  std::vector<const Character*> characters;
  for (const Character& character : scene.characters) characters.push_back(&character);
  return characters;
}

Result<void> check_names(CharacterSpan characters, std::span<const NamePair> pairs) {
  if (pairs.empty()) return {};
  std::vector<Names> names;
  for (const Character* character : characters) names.emplace_back(*character);
  const auto has = [&](const std::string& pattern) {
    return std::any_of(names.begin(), names.end(), [&](const Names& of_character) {
      return find_named(pattern, of_character).is_any();
    });
  };
  for (const NamePair& pair : pairs) {
    if (!has(pair.a)) return unknown_name(names, pair.a);
    if (!has(pair.b)) return unknown_name(names, pair.b);
  }
  return {};
}

Result<IgnoredPairs> IgnoredPairs::make(CharacterSpan characters, std::span<const NamePair> pairs) {
  IgnoredPairs ignored;
  if (pairs.empty()) return ignored;
  ignored.rules_.resize(pairs.size());
  for (const Character* character : characters) {
    const Result<TriangleLabels> labels = label_triangles(character->asset);
    if (!labels) return asset::prefixed(character->source, labels.error());
    const Names names(*character);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ignored.rules_[i].a.push_back(find_meant(pairs[i].a, names, *labels));
      ignored.rules_[i].b.push_back(find_meant(pairs[i].b, names, *labels));
    }
  }
  return ignored;
}

bool IgnoredPairs::is_ignored(std::uint32_t character_a, std::uint32_t triangle_a,
                              std::uint32_t character_b, std::uint32_t triangle_b) const {
  const auto means = [&](const Meant& x, const Meant& y) {
    return x[character_a][triangle_a] && y[character_b][triangle_b];
  };
  return std::any_of(rules_.begin(), rules_.end(), [&](const Rule& rule) {
    return means(rule.a, rule.b) || means(rule.b, rule.a);
  });
}

bool IgnoredPairs::are_ignored(const Body& a, const Body& b) const {
  const auto mean = [&](const Meant& x, const Meant& y) {
    return are_all_meant(x[a.character], a) && are_all_meant(y[b.character], b);
  };
  return std::any_of(rules_.begin(), rules_.end(), [&](const Rule& rule) {
    return mean(rule.a, rule.b) || mean(rule.b, rule.a);
  });
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
