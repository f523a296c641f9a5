#include "tools/pelt/check/between_json.hpp"

#include "scenes/takes.hpp"
#include "tools/pelt/check/feature_name.hpp"
#include "tools/pelt/check/touch_name.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

ordered_json feature_json(const Feature& feature) {
  ordered_json json = {{"kind", name_of(feature.kind)}};
  if (feature.kind != FeatureKind::face) json["number"] = feature.number;
  return json;
}

ordered_json contact_json(const Contact& contact, const FirstTouch& first) {
  return {{"triangles", {contact.triangle_a, contact.triangle_b}},
          {"first", first.seconds},
          {"features", {feature_json(first.a), feature_json(first.b)}}};
}

/// One object per pair of colliders.
ordered_json pairs_json(const StepContacts& step, bool lists_triangles) {
  ordered_json pairs = ordered_json::array();
  for (const scene::FrameContacts::Pair& pair : step.between.pairs) {
    double first = step.firsts[pair.begin].seconds;
    ordered_json list = ordered_json::array();
    for (std::size_t i = pair.begin; i < pair.end; ++i) {
      first = std::min(first, step.firsts[i].seconds);
      if (lists_triangles) list.push_back(contact_json(step.between.contacts[i], step.firsts[i]));
    }
    pairs.push_back(
        {{"a", pair.a}, {"b", pair.b}, {"only_between", pair.end - pair.begin}, {"first", first}});
    if (lists_triangles) pairs.back()["between"] = std::move(list);
  }
  return pairs;
}

void add_step(const scenes::Scene& scene, std::uint32_t from, ordered_json& object) {
  scene::add_frame(scene, from, "step", "clip_step", object);
}

ordered_json earliest_json(const scene::StagedScene& staged, const StepBetween& found) {
  ordered_json json;
  add_step(staged.scene, found.from, json);
  json["a"] = found.earliest.a;
  json["b"] = found.earliest.b;
  json.update(contact_json(found.earliest.contact, found.earliest.first));
  return json;
}

ordered_json deviation_json(const scene::StagedScene& staged, const BetweenReport& report) {
  if (report.falls.empty()) return nullptr;
  ordered_json json = {{"distance", report.deviation.distance}};
  add_step(staged.scene, report.deviation.from, json);
  json["instance"] = staged.colliders[report.deviation.collider].instance;
  json["substeps"] = ordered_json::array();
  for (const BetweenReport::Fall& fall : report.falls)
    json["substeps"].push_back({{"substeps", fall.substeps}, {"distance", fall.distance}});
  return json;
}

}  // namespace

ordered_json step_json(const scene::StagedScene& staged, const StepContacts& step,
                       bool lists_triangles) {
  const scenes::Take* const take = scenes::find_take(staged.scene, step.from);
  ordered_json line;
  add_step(staged.scene, step.from, line);
  line["to"] = step.to;
  if (take != nullptr) line["clip"] = take->clip;
  line["time"] = scenes::frame_time(staged.scene, step.from);
  line["end_time"] = scenes::frame_time(staged.scene, step.to);
  line["contacts"] = step.contacts;
  line["only_between"] = step.firsts.size();
  line["first"] = step.firsts[step.earliest()].seconds;
  line["pairs"] = pairs_json(step, lists_triangles);
  return line;
}

ordered_json between_json(const scene::StagedScene& staged, const BetweenReport& report) {
  ordered_json json = {{"steps", report.steps},
                       {"steps_in_contact", report.found.size()},
                       {"contacts", report.contacts},
                       {"earliest", nullptr},
                       {"deviation", deviation_json(staged, report)},
                       {"counters", scene::counters_json(report.work)},
                       {"hash", output::hex16(report.hash)}};
  if (!report.found.empty()) json["earliest"] = earliest_json(staged, report.found.front());
  return json;
}

ordered_json touch_between_json(const scene::StagedScene& staged, const Touch& touch) {
  ordered_json json = touch_json(staged, touch);
  json.erase("frames");
  json.erase("worst");
  json["steps"] = touch.frames;
  json["worst"] = ordered_json::object();
  add_step(staged.scene, touch.worst_frame, json["worst"]);
  json["worst"]["contacts"] = touch.worst;
  return json;
}

}  // namespace pelt::tools::check
