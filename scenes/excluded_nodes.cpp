#include "scenes/excluded_nodes.hpp"

#include "text/message.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace pelt::scenes {
namespace {

/// Returns the part of a name that applies to nodes of the model.
std::string name_in(const std::string& model, const std::string& name) {
  return name.starts_with(model + "/") ? name.substr(model.size() + 1) : name;
}

bool is_file(const Character& character) {
  return std::holds_alternative<std::filesystem::path>(character.origin);
}

bool has(const Character& character, const std::string& name) {
  const auto& nodes = character.asset.nodes;
  return is_file(character) &&
         std::any_of(nodes.begin(), nodes.end(), [&](const asset::Node& node) {
           return node.name == name_in(character.name, name);
         });
}

Error unknown_node(const Scene& scene, const std::string& name) {
  std::set<std::string> names;
  for (const Character& character : scene.characters) {
    if (!is_file(character)) continue;
    for (const asset::Part& part : character.asset.parts)
      names.insert(name.find('/') == name.npos ? part.node : character.name + "/" + part.node);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return {
      ErrorCode::invalid_argument,
      "no node to exclude is named " + text::quoted(name) +
          (known.empty() ? ": the characters of the scene do not come from files, exclude nothing"
                         : text::suggestion(name, known))};
}

}  // namespace

asset::GltfOptions options_for(const std::string& model, const asset::GltfOptions& options) {
  asset::GltfOptions own = options;
  own.excluded_must_exist = false;
  for (std::string& name : own.exclude_nodes) name = name_in(model, name);
  return own;
}

Result<void> check_excluded(const Scene& scene, const asset::GltfOptions& options) {
  for (const std::string& name : options.exclude_nodes) {
    const auto has_it = [&](const Character& character) { return has(character, name); };
    if (std::none_of(scene.characters.begin(), scene.characters.end(), has_it))
      return unknown_node(scene, name);
  }
  return {};
}

}  // namespace pelt::scenes
