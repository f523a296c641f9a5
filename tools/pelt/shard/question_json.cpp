#include "tools/pelt/shard/question_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pelt::tools::shard {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// Calls `visit` with the name and the value of each argument.
template <typename Arguments, typename Visit>
void visit_arguments(Arguments& of, const Visit& visit) {
  visit("inputs", of.scene.inputs);
  visit("scenes", of.scenes);
  visit("clip", of.scene.clips);
  visit("start", of.scene.starts);
  visit("at", of.scene.positions);
  visit("turn", of.scene.turns);
  visit("scale", of.scene.scales);
  visit("fps", of.scene.fps);
  visit("no_unskinned", of.scene.models.no_unskinned);
  visit("exclude", of.scene.models.exclude);
  visit("renormalise", of.scene.models.renormalise);
  visit("skinning", of.scene.models.skinning);
  visit("samples", of.scene.models.samples);
  visit("frames", of.frames);
  visit("by", of.by);
  visit("method", of.method);
  visit("first", of.first);
  visit("max_contacts", of.max_contacts);
  visit("self", of.self.self);
  visit("self_rings", of.self.rings);
  visit("self_at_rest", of.self.at_rest);
  visit("self_always", of.self.always);
  visit("self_near_joints", of.self.near_joints);
  visit("ignore", of.ignore);
  visit("pairs", of.pairs);
  visit("contacts", of.contacts);
  visit("inside", of.inside);
  visit("clearance", of.clearance);
  visit("budget", of.budget);
  visit("between", of.between);
  visit("substeps", of.substeps);
  visit("baseline", of.baseline);
  visit("fail_on", of.fail_on);
  visit("allow_empty", of.allow_empty);
}

bool read(const json& value, bool& to) {
  if (value.is_boolean()) to = value.get<bool>();
  return value.is_boolean();
}

bool read(const json& value, std::uint32_t& to) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xFFFFFFFF) return false;
  to = value.get<std::uint32_t>();
  return true;
}

bool read(const json& value, double& to) {
  if (!value.is_number()) return false;
  to = value.get<double>();
  return std::isfinite(to);
}

bool read(const json& value, std::string& to) {
  if (value.is_string()) to = value.get<std::string>();
  return value.is_string();
}

template <typename T>
bool read(const json& value, std::optional<T>& to) {
  to.reset();
  return value.is_null() || read(value, to.emplace());
}

template <typename T>
bool read(const json& value, std::vector<T>& to) {
  to.clear();
  return value.is_array() && std::all_of(value.begin(), value.end(), [&](const json& one) {
           return read(one, to.emplace_back());
         });
}

template <typename T>
ordered_json to_json(const T& value) {
  return value;
}

template <typename T>
ordered_json to_json(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

}  // namespace

ordered_json arguments_json(const check::CheckArguments& arguments) {
  ordered_json object;
  visit_arguments(arguments,
                  [&](const char* name, const auto& value) { object[name] = to_json(value); });
  return object;
}

bool read_arguments(const json& object, check::CheckArguments& arguments) {
  bool is_good = object.is_object();
  visit_arguments(arguments, [&](const char* name, auto& value) {
    const auto found = is_good ? object.find(name) : object.end();
    is_good = is_good && found != object.end() && read(*found, value);
  });
  return is_good && arguments.scene.inputs.empty() != arguments.scenes.empty();
}

}  // namespace pelt::tools::shard
