#include "tools/pelt/check/jsonl.hpp"

#include "scenes/takes.hpp"
#include "text/format.hpp"
#include "tools/pelt/check/frame_line.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

ordered_json feature_json(const Feature& feature) {
  ordered_json json = {{"kind", kFeatureNames[static_cast<std::size_t>(feature.kind)]}};
  if (feature.kind != FeatureKind::face) json["number"] = feature.number;
  return json;
}

/// A contact of a step, with its first time and the features that meet.
ordered_json first_touch_json(const Contact& contact, const FirstTouch& first) {
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
      if (lists_triangles)
        list.push_back(first_touch_json(step.between.contacts[i], step.firsts[i]));
    }
    pairs.push_back(
        {{"a", pair.a}, {"b", pair.b}, {"only_between", pair.end - pair.begin}, {"first", first}});
    if (lists_triangles) pairs.back()["between"] = std::move(list);
  }
  return pairs;
}

/// Adds the frame from which a step starts, as `step`.
void add_step(const scenes::Scene& scene, std::uint32_t from, ordered_json& object) {
  scene::add_frame(scene, from, "step", "clip_step", object);
}

/// The line of a step with contacts between its frames. `lists_triangles`: also all contacts, with
/// times and features.
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

/// An object with `clip`, or an empty one without a clip.
ordered_json of_clip(const std::optional<std::string>& clip) {
  ordered_json json = ordered_json::object();
  if (clip) json["clip"] = *clip;
  return json;
}

/// Without numbers of instances, for places that are no longer in the scene.
ordered_json name_json(const BodyName& name) {
  ordered_json body = {{"model", name.model}, {"copy", name.copy}};
  if (!name.part.empty()) body["part"] = name.part;
  return body;
}

ordered_json name_json(const TouchName& name) {
  ordered_json place = name_json(name.body);
  place["joint"] = name.joint;
  return place;
}

ordered_json with_instance(std::uint32_t instance, const ordered_json& name) {
  ordered_json place = {{"instance", instance}};
  place.update(name);
  return place;
}

/// `instance` is the number in the scene.
ordered_json touch_json(const scene::StagedScene& staged, const Touch& touch) {
  ordered_json json = of_clip(clip_name(staged.scene, touch.take));
  json.update(
      ordered_json{{"a", with_instance(touch.a.instance, name_json(touch_name(staged, touch.a)))},
                   {"b", with_instance(touch.b.instance, name_json(touch_name(staged, touch.b)))},
                   {"contacts", touch.contacts},
                   {"frames", touch.frames},
                   {"worst", scene::worst_json(staged.scene, touch.worst_frame, touch.worst)}});
  return json;
}

ordered_json held_json(const scene::StagedScene& staged, const Held& held) {
  const auto body = [&](std::uint32_t collider) {
    return with_instance(staged.colliders[collider].instance,
                         name_json(body_name(staged, staged.colliders[collider])));
  };
  ordered_json json = of_clip(clip_name(staged.scene, held.take));
  json.update(ordered_json{
      {"inner", body(held.inner)}, {"outer", body(held.outer)}, {"frames", held.frames}});
  scene::add_frame(staged.scene, held.first_frame, "first_frame", "first_clip_frame", json);
  return json;
}

/// Returns a touch between frames, with steps instead of frames.
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

ordered_json earliest_json(const scene::StagedScene& staged, const StepBetween& found) {
  ordered_json json;
  add_step(staged.scene, found.from, json);
  json["a"] = found.earliest.a;
  json["b"] = found.earliest.b;
  json.update(first_touch_json(found.earliest.contact, found.earliest.first));
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

/// `totals.between`.
ordered_json between_json(const scene::StagedScene& staged, const BetweenReport& report) {
  ordered_json json = {{"steps", report.steps},
                       {"steps_in_contact", report.found.size()},
                       {"contacts", report.contacts},
                       {"earliest", nullptr},
                       {"deviation", deviation_json(staged, report)},
                       {"counters", scene::counters_json(report.work)},
                       {"hash", text::hex16(report.hash)}};
  if (!report.found.empty()) json["earliest"] = earliest_json(staged, report.found.front());
  return json;
}

ordered_json gone_json(const GoneTouch& gone) {
  ordered_json touch = of_clip(gone.names.clip);
  touch["a"] = name_json(gone.names.first);
  touch["b"] = name_json(gone.names.second);
  touch["known"] = gone.known;
  return touch;
}

ordered_json held_names_json(const CheckBaseline::HeldNames& names) {
  ordered_json bodies = of_clip(names.clip);
  bodies["inner"] = name_json(names.inner);
  bodies["outer"] = name_json(names.outer);
  return bodies;
}

ordered_json takes_json(const scenes::Scene& scene, std::span<const TakeTotals> takes) {
  ordered_json list = ordered_json::array();
  for (const TakeTotals& totals : takes) {
    const scenes::Take& take = scene.takes[totals.take];
    list.push_back({{"clip", take.clip},
                    {"first_frame", take.first_frame},
                    {"frames", totals.frames},
                    {"frames_in_contact", totals.frames_in_contact},
                    {"contacts", totals.contacts},
                    {"worst", nullptr}});
    if (totals.worst > 0)
      list.back()["worst"] = scene::worst_json(scene, totals.worst_frame, totals.worst);
  }
  return list;
}

}  // namespace

void JsonlWriter::header() {
  if (out_ == nullptr) return;
  scene::write_header("pelt-check", stage_.staged,
                      question_json(stage_.settings, stage_.staged.scene), *out_);
}

void JsonlWriter::step(const StepContacts& step) {
  if (out_ == nullptr) return;
  scene::write_line(step_json(stage_.staged, step, stage_.settings.options.pairs), *out_);
}

void JsonlWriter::frame(const FrameAnswer& answer) {
  if (out_ != nullptr) *out_ << answer.line << '\n';
}

ordered_json JsonlWriter::held_list(std::span<const Held> held) const {
  ordered_json list = ordered_json::array();
  for (const Held& h : held) list.push_back(held_json(stage_.staged, h));
  return list;
}

/// Appends to the lists of `json`.
void JsonlWriter::add_changes(const TouchChanges& changes, TouchJson* json_of,
                              ordered_json& json) const {
  for (const Worse& worse : changes.worse) {
    json["worse"].push_back(json_of(stage_.staged, worse.touch));
    json["worse"].back()["known"] = worse.known;
  }
  for (const GoneTouch& gone : changes.gone) json["gone"].push_back(gone_json(gone));
  for (const GoneTouch& gone : changes.left_out) json["left_out"].push_back(gone_json(gone));
}

ordered_json JsonlWriter::verdict_json(const Verdict& verdict) const {
  ordered_json json = {{"fail_on", name_of(verdict.fail_on)},
                       {"failed", verdict.is_failed},
                       {"pairs_compared", verdict.pairs_compared}};
  for (const char* key : {"worse", "gone", "left_out", "newly_held", "no_longer_held", "notes"})
    json[key] = verdict.comparison ? ordered_json::array() : ordered_json();
  if (!verdict.comparison) return json;
  const Comparison& comparison = *verdict.comparison;
  add_changes(comparison.touches, touch_json, json);
  if (stage_.settings.substeps) {
    json["between"] = {{"worse", ordered_json::array()},
                       {"gone", ordered_json::array()},
                       {"left_out", ordered_json::array()}};
    add_changes(comparison.between, touch_between_json, json["between"]);
  }
  json["newly_held"] = held_list(comparison.newly_held);
  for (const CheckBaseline::HeldNames& names : comparison.no_longer_held)
    json["no_longer_held"].push_back(held_names_json(names));
  json["notes"] = comparison.notes;
  return json;
}

void JsonlWriter::totals(const Findings& found, const Verdict& verdict) {
  if (out_ == nullptr) return;
  const CheckTotals& totals = found.totals;
  ordered_json last = {{"totals",
                        {{"frames", totals.frames},
                         {"frames_in_contact", totals.frames_in_contact},
                         {"contacts", totals.contacts},
                         {"ignored", totals.ignored}}},
                       {"counters", scene::counters_json(totals.work)},
                       {"hash", nullptr}};
  if (totals.hash) {
    last["hash"] = text::hex16(*totals.hash);
  } else {
    last["cut_short"] = true;
  }
  if (stage_.settings.options.budget)
    last["totals"]["unknown"] = {{"frames", totals.unknown.frames.size()},
                                 {"pairs", totals.unknown.most_pairs},
                                 {"resolution", totals.unknown.resolution}};
  if (stage_.settings.self.asks_self()) last["totals"]["left_out"] = left_out_json(totals.left_out);
  if (!totals.takes.empty()) last["clips"] = takes_json(stage_.staged.scene, totals.takes);
  last["touches"] = ordered_json::array();
  for (const Touch& touch : found.touches)
    last["touches"].push_back(touch_json(stage_.staged, touch));
  if (totals.between) {
    last["totals"]["between"] = between_json(stage_.staged, *totals.between);
    last["touches_between"] = ordered_json::array();
    for (const Touch& touch : found.between())
      last["touches_between"].push_back(touch_between_json(stage_.staged, touch));
  }
  if (stage_.settings.options.inside) last["held"] = held_list(found.held);
  last["verdict"] = verdict_json(verdict);
  scene::write_line(last, *out_);
}

}  // namespace pelt::tools::check
