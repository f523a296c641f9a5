#include "tools/pelt/check/jsonl.hpp"

#include "tools/pelt/check/between_json.hpp"
#include "tools/pelt/check/frame_line.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

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
  scene::write_header("pelt-check", staged_, question_json(question_), *out_);
}

void JsonlWriter::step(const StepContacts& step) {
  if (out_ != nullptr) scene::write_line(step_json(staged_, step, question_.pairs), *out_);
}

void JsonlWriter::frame(const FrameAnswer& answer) {
  if (out_ != nullptr) *out_ << answer.line << '\n';
}

ordered_json JsonlWriter::held_list(std::span<const Held> held) const {
  ordered_json list = ordered_json::array();
  for (const Held& h : held) list.push_back(held_json(staged_, h));
  return list;
}

/// Appends to the lists of `json`.
void JsonlWriter::add_changes(const TouchChanges& changes, TouchJson* json_of,
                              ordered_json& json) const {
  for (const Worse& worse : changes.worse) {
    json["worse"].push_back(json_of(staged_, worse.touch));
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
  if (question_.substeps) {
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

void JsonlWriter::totals(const CheckTotals& totals, const Findings& found, const Verdict& verdict) {
  if (out_ == nullptr) return;
  ordered_json last = {{"totals",
                        {{"frames", totals.frames},
                         {"frames_in_contact", totals.frames_in_contact},
                         {"contacts", totals.contacts},
                         {"ignored", totals.ignored}}},
                       {"counters", scene::counters_json(totals.work)},
                       {"hash", nullptr}};
  if (totals.hash) {
    last["hash"] = output::hex16(*totals.hash);
  } else {
    last["cut_short"] = true;
  }
  if (question_.budget)
    last["totals"]["unknown"] = {{"frames", totals.unknown.frames.size()},
                                 {"pairs", totals.unknown.most_pairs},
                                 {"resolution", totals.unknown.resolution}};
  if (question_.self.asks_self()) last["totals"]["left_out"] = left_out_json(totals.left_out);
  if (!totals.takes.empty()) last["clips"] = takes_json(staged_.scene, totals.takes);
  last["touches"] = ordered_json::array();
  for (const Touch& touch : found.touches) last["touches"].push_back(touch_json(staged_, touch));
  if (totals.between) {
    last["totals"]["between"] = between_json(staged_, *totals.between);
    last["touches_between"] = ordered_json::array();
    for (const Touch& touch : found.between)
      last["touches_between"].push_back(touch_between_json(staged_, touch));
  }
  if (question_.inside) last["held"] = held_list(found.held);
  last["verdict"] = verdict_json(verdict);
  scene::write_line(last, *out_);
}

}  // namespace pelt::tools::check
