#include "tools/pelt/jsonl.hpp"

#include <pelt/version.hpp>

#include "tools/pelt/text.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools {
namespace {

using nlohmann::ordered_json;

ordered_json inputs_json(const scenes::Scene& scene) {
  ordered_json inputs = ordered_json::array();
  for (const scenes::Character& character : scene.characters) {
    inputs.push_back({{"path", character.source}, {"hash", hex16(character.hash)}});
  }
  return inputs;
}

ordered_json colliders_json(const scenes::Scene& scene, std::span<const Collider> colliders) {
  ordered_json instances = ordered_json::array();
  for (std::size_t c = 0; c < colliders.size(); ++c) {
    const Collider& collider = colliders[c];
    const scenes::Character& character =
        scene.characters[scene.instances[collider.instance].character];
    ordered_json& entry = instances.emplace_back();
    entry["index"] = c;
    entry["model"] = character.name;
    entry["triangles"] = collider.model.triangle_count();
    if (!collider.part) continue;
    entry["instance"] = collider.instance;
    entry["part"] = part_name(character.asset, *collider.part);
    entry["first_triangle"] = collider.first_triangle;
  }
  return instances;
}

ordered_json triangles_json(std::span<const Contact> contacts) {
  ordered_json triangles = ordered_json::array();
  for (const Contact& contact : contacts) {
    triangles.push_back({contact.triangle_a, contact.triangle_b});
  }
  return triangles;
}

}  // namespace

ordered_json counters_json(const QueryStats& work) {
  return {{"node_pairs", work.node_pairs},
          {"refits", work.refits},
          {"posed_vertices", work.posed_vertices},
          {"triangle_pairs", work.triangle_pairs}};
}

void JsonlWriter::header(const scenes::Scene& scene, std::span<const Collider> colliders,
                         const CheckOptionsShown& options) {
  ordered_json shown = {
      {"method", options.method},
      {"by", options.by},
      {"frames", {options.frames.begin, options.frames.end, options.frames.stride}},
      {"fps", scene.fps},
      {"max_contacts", nullptr},
      {"pairs", lists_ == TriangleLists::written}};
  if (options.max_contacts) shown["max_contacts"] = *options.max_contacts;
  line({{"format", "pelt-check"},
        {"version", 1},
        {"pelt", PELT_VERSION},
        {"inputs", inputs_json(scene)},
        {"instances", colliders_json(scene, colliders)},
        {"options", std::move(shown)}});
}

void JsonlWriter::frame(std::uint32_t frame, double time, const FrameContacts& found) {
  ordered_json pairs = ordered_json::array();
  for (const FrameContacts::Pair& pair : found.pairs) {
    ordered_json& entry = pairs.emplace_back();
    entry["a"] = pair.a;
    entry["b"] = pair.b;
    entry["contacts"] = pair.end - pair.begin;
    if (lists_ == TriangleLists::written) entry["triangles"] = triangles_json(found.of(pair));
  }
  line({{"frame", frame},
        {"time", time},
        {"contacts", found.contacts.size()},
        {"pairs", std::move(pairs)}});
}

void JsonlWriter::totals(const CheckTotals& totals) {
  ordered_json last = {{"totals",
                        {{"frames", totals.frames},
                         {"frames_in_contact", totals.frames_in_contact},
                         {"contacts", totals.contacts}}},
                       {"counters", counters_json(totals.work)},
                       {"hash", nullptr}};
  if (totals.hash) {
    last["hash"] = hex16(*totals.hash);
  } else {
    last["cut_short"] = true;
  }
  line(last);
}

/// Names of files may be no UTF-8; JSON must be.
void JsonlWriter::line(const ordered_json& value) {
  out_ << value.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace pelt::tools
