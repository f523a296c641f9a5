#include "bindings/wasm/engine/options.hpp"

#include "asset/parsed_json.hpp"
#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/export.hpp"
#include "text/message.hpp"

namespace pelt::wasm {

Result<Options> Options::read(std::string_view json) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(json);
  if (!parsed)
    return Error{ErrorCode::invalid_argument, text::prefixed("options", parsed.error()).message};
  return Options(std::move(**parsed));
}

std::string Options::text(const char* key) const {
  const auto found = values_.find(key);
  return found != values_.end() && found->is_string() ? found->get<std::string>() : "";
}

std::optional<std::vector<std::string>> Options::texts(const char* key) const {
  const auto found = values_.find(key);
  if (found == values_.end() || !found->is_array()) return std::nullopt;
  std::vector<std::string> texts;
  for (const nlohmann::json& element : *found)
    if (element.is_string()) texts.push_back(element.get<std::string>());
  return texts;
}

std::optional<float> Options::number(const char* key) const {
  const auto found = values_.find(key);
  if (found == values_.end() || !found->is_number()) return std::nullopt;
  return found->get<float>();
}

asset::GltfOptions Options::gltf() const {
  asset::GltfOptions options;
  options.unskinned_parts = !flag("noUnskinned");
  options.exclude_nodes = texts("exclude").value_or(std::vector<std::string>());
  return options;
}

scenes::CreatureOptions Options::creature() const {
  const scenes::CreatureOptions defaults;
  return {count("triangles", defaults.triangles), count("joints", defaults.joints),
          count("seed", defaults.seed)};
}

scenes::FaceOptions Options::face() const {
  const scenes::FaceOptions defaults;
  return {count("triangles", defaults.triangles), count("seed", defaults.seed)};
}

Preparation Options::preparation() const {
  Preparation preparation;
  preparation.samples = count("samples", preparation.samples);
  preparation.renormalise = flag("renormalise");
  preparation.weld = flag("weld", preparation.weld);
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion})
    if (text("skinning") == scenes::name_of(skinning)) preparation.skinning = skinning;
  return preparation;
}

bool Options::flag(const char* key, bool otherwise) const {
  const auto found = values_.find(key);
  return found != values_.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

std::uint32_t Options::count(const char* key, std::uint32_t otherwise) const {
  const auto found = values_.find(key);
  const bool is_there = found != values_.end() && found->is_number_unsigned();
  return is_there ? found->get<std::uint32_t>() : otherwise;
}

/// Returns the end of a message about an unknown name. `words` has this name, then the known names.
const char* suggestion(std::string_view words) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(words);
  if (!parsed) return "";
  const auto names = (*parsed)->get<std::vector<std::string>>();
  const std::vector<std::string_view> known(names.begin() + 1, names.end());
  return answer_text(text::suggestion(names.front(), known));
}
PELT_EXPORT(suggestion)

}  // namespace pelt::wasm
