#include "tools/pelt/shard/shard_header.hpp"

#include <pelt/version.hpp>

#include "asset/file_bytes.hpp"
#include "asset/message.hpp"
#include "asset/parsed_json.hpp"
#include "base/hash.hpp"
#include "tools/pelt/list/scene_list.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/shard/question_json.hpp"

#include <charconv>

namespace pelt::tools::shard {
namespace {

using nlohmann::json;

constexpr std::uint32_t kVersion = 2;

/// 0 for anything but a whole number from 1 to `most`.
std::uint32_t parse_number(std::string_view text, std::uint32_t most) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value <= most ? value : 0;
}

bool read_shard(const json& value, Shard& shard) {
  if (!value.is_array() || value.size() != 2) return false;
  for (const json& number : value)
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > kMostShards) return false;
  shard = {value[0].get<std::uint32_t>(), value[1].get<std::uint32_t>()};
  return shard.index >= 1 && shard.index <= shard.count;
}

/// "path" and "hash" of a file.
Result<nlohmann::ordered_json> input_json(const std::string& path) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return bytes.error();
  detail::Fnv1a64 hash;
  hash.add_bytes(*bytes);
  return nlohmann::ordered_json{{"path", path}, {"hash", output::hex16(hash.value())}};
}

/// Whether the first input is a list with a number of scenes.
bool has_list(const json& inputs) {
  if (inputs.empty() || !inputs[0].is_object()) return false;
  const json scenes = inputs[0].value("scenes", json());
  return scenes.is_number_unsigned() && scenes.get<std::uint64_t>() <= list::kMostScenes;
}

Error not_a_shard() {
  return asset::malformed("not a file of a shard: give files that pelt check --shard wrote");
}

}  // namespace

Result<Shard> parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard = {0, 0};
  if (slash != std::string::npos) {
    shard.count = parse_number(std::string_view(text).substr(slash + 1), kMostShards);
    shard.index = parse_number(std::string_view(text).substr(0, slash), shard.count);
  }
  if (shard.index > 0) return shard;
  return output::bad_argument("--shard", asset::quoted(text) + " is not a shard",
                              "give I/N, the I-th of N shards, from 1/N to N/N");
}

Result<json> inputs_of(const arguments::SceneArguments& arguments, const scenes::Scene& scene) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  if (arguments::asks_for_scene(arguments)) {
    auto input = input_json(arguments.inputs[0]);
    if (!input) return input.error();
    inputs.push_back(std::move(*input));
  }
  for (const scenes::Character& character : scene.characters)
    inputs.push_back({{"path", character.source}, {"hash", output::hex16(character.hash)}});
  return scene::as_json_holds(inputs);
}

Result<json> inputs_of(const list::ListPlan& plan) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (const std::string& path : {plan.arguments.scenes, plan.arguments.baseline}) {
    if (path.empty()) continue;
    auto input = input_json(path);
    if (!input) return input.error();
    inputs.push_back(std::move(*input));
  }
  inputs[0]["scenes"] = plan.scenes.size();
  return scene::as_json_holds(inputs);
}

std::size_t scenes_of(const json& inputs) { return inputs[0]["scenes"].get<std::size_t>(); }

nlohmann::ordered_json header_json(const Shard& shard, const check::CheckArguments& arguments,
                                   const json& inputs) {
  return {{"format", "pelt-shard"},
          {"version", kVersion},
          {"pelt", PELT_VERSION},
          {"shard", {shard.index, shard.count}},
          {"arguments", arguments_json(arguments)},
          {"inputs", inputs}};
}

Result<ShardHeader> read_header(const std::string& line) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(line);
  if (!parsed || !(*parsed)->is_object() || (*parsed)->value("format", json()) != "pelt-shard")
    return not_a_shard();
  const json& object = **parsed;
  const json version = object.value("version", json()), pelt = object.value("pelt", json());
  if (version != kVersion || pelt != PELT_VERSION)
    return asset::unsupported("was written by another version of pelt (" + pelt.dump() +
                              "): write and merge all shards with one version");
  ShardHeader header;
  if (!read_shard(object.value("shard", json()), header.shard) ||
      !read_arguments(object.value("arguments", json()), header.arguments) ||
      !object.value("inputs", json()).is_array())
    return asset::malformed("the first line is damaged: write this shard again");
  if (!header.arguments.scenes.empty() && !has_list(object["inputs"]))
    return asset::malformed("the first line is damaged: write this shard again");
  header.question = {{"arguments", object["arguments"]}, {"inputs", object["inputs"]}};
  return header;
}

}  // namespace pelt::tools::shard
