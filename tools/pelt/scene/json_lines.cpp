#include "tools/pelt/scene/json_lines.hpp"

#include <pelt/version.hpp>

#include "scenes/takes.hpp"
#include "text/format.hpp"
#include "text/json_text.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::scene {
namespace {

using nlohmann::ordered_json;

ordered_json inputs_json(const scenes::Scene& scene) {
  ordered_json inputs = ordered_json::array();
  for (const scenes::Character& character : scene.characters) {
    inputs.push_back({{"path", character.source}, {"hash", text::hex16(character.hash)}});
  }
  return inputs;
}

ordered_json colliders_json(const StagedScene& staged) {
  ordered_json instances = ordered_json::array();
  for (std::size_t c = 0; c < staged.colliders.size(); ++c) {
    const Collider& collider = staged.colliders[c];
    const std::uint32_t character = staged.scene.instances[collider.instance].character;
    ordered_json& entry = instances.emplace_back();
    entry["index"] = c;
    entry["model"] = staged.scene.characters[character].name;
    entry["triangles"] = collider.model.triangle_count();
    if (!collider.part) continue;
    entry["instance"] = collider.instance;
    entry["part"] = staged.names->part(character, *collider.part);
    entry["first_triangle"] = collider.first_triangle;
  }
  return instances;
}

}  // namespace

void write_header(const char* format, const StagedScene& staged, const ordered_json& options,
                  std::ostream& out) {
  write_line({{"format", format},
              {"version", 1},
              {"pelt", PELT_VERSION},
              {"inputs", inputs_json(staged.scene)},
              {"instances", colliders_json(staged)},
              {"options", options}},
             out);
}

void add_frame(const scenes::Scene& scene, std::uint32_t frame, ordered_json& object) {
  object["frame"] = frame;
  const scenes::Take* const take = scenes::find_take(scene, frame);
  if (take == nullptr) return;
  object["clip"] = take->clip;
  object["clip_frame"] = scenes::frame_in_take(scene, frame);
}

ordered_json frame_json(const scenes::Scene& scene, std::uint32_t frame) {
  ordered_json json;
  add_frame(scene, frame, json);
  json["time"] = scenes::frame_time(scene, frame);
  return json;
}

void add_frame(const scenes::Scene& scene, std::uint32_t frame, const char* key,
               const char* clip_key, ordered_json& object) {
  object[key] = frame;
  if (!scene.takes.empty()) object[clip_key] = scenes::frame_in_take(scene, frame);
}

ordered_json worst_json(const scenes::Scene& scene, std::uint32_t frame, std::uint64_t contacts) {
  ordered_json worst;
  add_frame(scene, frame, "frame", "clip_frame", worst);
  worst["contacts"] = contacts;
  return worst;
}

ordered_json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

ordered_json counters_json(const QueryStats& work) {
  return {{"node_pairs", work.node_pairs},
          {"refits", work.refits},
          {"posed_vertices", work.posed_vertices},
          {"triangle_pairs", work.triangle_pairs},
          {"displacements", work.displacements}};
}

nlohmann::json as_json_holds(const ordered_json& value) {
  return nlohmann::json::parse(text::json_text(value));
}

std::string as_json_holds(const std::string& text) {
  return as_json_holds(ordered_json(text)).get<std::string>();
}

void write_line(const ordered_json& value, std::ostream& out) {
  out << text::json_text(value) << '\n';
}

JsonLine::JsonLine(std::ostream& out) : out_(out) { out_ << '{'; }

void JsonLine::members(const ordered_json& object) {
  for (const auto& [name, value] : object.items()) {
    key(name);
    out_ << text::json_text(value);
  }
}

void JsonLine::begin_object(const char* name) { open(name, '{'); }
void JsonLine::end_object() { close('}'); }
void JsonLine::begin_list(const char* name) { open(name, '['); }
void JsonLine::end_list() { close(']'); }

void JsonLine::item(const ordered_json& value) {
  separate();
  out_ << text::json_text(value);
}

void JsonLine::end() { out_ << "}\n"; }

void JsonLine::separate() {
  if (!is_first_) out_ << ',';
  is_first_ = false;
}

void JsonLine::key(const std::string& name) {
  separate();
  out_ << text::json_text(name) << ':';
}

void JsonLine::open(const char* name, char bracket) {
  key(name);
  out_ << bracket;
  is_first_ = true;
}

void JsonLine::close(char bracket) {
  out_ << bracket;
  is_first_ = false;
}

}  // namespace pelt::tools::scene
