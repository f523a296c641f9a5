#include "tools/pelt/check/report.hpp"

#include "scenes/takes.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools::check {
namespace {

/// Frames ascend, so the frames of a take are consecutive.
void count_in_take(std::uint32_t take, std::uint32_t frame, std::uint64_t contacts,
                   std::vector<TakeTotals>& takes) {
  if (takes.empty() || takes.back().take != take) takes.push_back({take});
  TakeTotals& totals = takes.back();
  ++totals.frames;
  totals.frames_in_contact += contacts > 0;
  totals.contacts += contacts;
  if (contacts <= totals.worst) return;
  totals.worst = contacts;
  totals.worst_frame = frame;
}

void count_frame(const scenes::Scene& scene, std::uint32_t frame, const scene::FrameContacts& found,
                 CheckReport& report) {
  const std::uint64_t contacts = found.contacts.size();
  ++report.totals.frames;
  report.frame_contacts.push_back(contacts);
  report.totals.contacts += contacts;
  if (!scene.takes.empty())
    count_in_take(scenes::take_index(scene, frame), frame, contacts, report.totals.takes);
  if (contacts == 0) return;
  ++report.totals.frames_in_contact;
  report.frames_in_contact.push_back(frame);
  if (contacts <= report.worst_contacts) return;
  report.worst_contacts = contacts;
  report.worst_frame = frame;
}

/// Whether this frame is the one to keep, judging by the frames so far.
bool is_to_be_kept(std::uint32_t frame, const CheckSettings& settings, const CheckReport& report) {
  if (settings.options.glb_frame) return frame == *settings.options.glb_frame;
  return frame == settings.frames.begin ||
         (report.worst_contacts > 0 && frame == report.worst_frame);
}

/// Returns nullopt if --self-always is chosen, or if there are too few frames or contacts to
/// suggest it.
std::optional<AlwaysTally> make_always_tally(const Stage& stage) {
  constexpr std::size_t kFewestFrames = 8;
  const CheckSettings& settings = stage.settings;
  if (!settings.self.asks_self() || settings.self.is_always_chosen || settings.max_contacts ||
      stage.frames.size() < kFewestFrames)
    return std::nullopt;
  return AlwaysTally(stage.staged, stage.frames.size(), kSuggestedShare);
}

}  // namespace

Findings findings_of(const CheckReport& report, std::span<const Touch> touches) {
  return {report.totals, touches, report.inside ? report.inside->held : std::span<const Held>()};
}

CheckRecord::CheckRecord(const Stage& stage, TouchTally& tally, JsonlWriter& jsonl)
    : stage_(stage),
      settings_(stage.settings),
      tally_(tally),
      jsonl_(jsonl),
      always_(make_always_tally(stage)),
      patches_(stage.staged) {
  if (settings_.options.inside) inside_.emplace();
  if (settings_.substeps) between_.emplace(stage.staged, *settings_.substeps, tally);
  report_.worst_frame = settings_.frames.begin;
}

void CheckRecord::add(const FrameAnswer& answer) {
  count(answer);
  if (inside_)
    inside_->add(answer.frame, answer.inside,
                 scenes::take_index(stage_.staged.scene, answer.frame));
  tally_.add(answer.frame, answer.found);
  if (always_) always_->add(answer.found);
  hash_.add(answer.frame, answer.found);
  patches_.add(answer.frame, answer.patches);
  if (between_) {
    if (const StepContacts* const step = between_->add(answer)) jsonl_.step(*step);
  }
  jsonl_.frame(answer);
  if (is_to_be_kept(answer.frame, settings_, report_)) report_.kept = {answer.frame, answer.found};
}

void CheckRecord::count(const FrameAnswer& answer) {
  report_.totals.ignored += answer.ignored;
  report_.totals.left_out += answer.left_out;
  report_.totals.work += answer.work;
  report_.frame_seconds.push_back(answer.seconds);
  count_frame(stage_.staged.scene, answer.frame, answer.found, report_);
  count_unknown(answer);
}

void CheckRecord::count_unknown(const FrameAnswer& answer) {
  if (answer.undecided.empty()) return;
  UnknownTotals& totals = report_.totals.unknown;
  totals.frames.push_back(answer.frame);
  std::uint64_t pairs = 0;
  for (const Undecided& undecided : answer.undecided) {
    pairs += undecided.pairs;
    totals.resolution = std::max(totals.resolution, undecided.resolution);
  }
  totals.most_pairs = std::max(totals.most_pairs, pairs);
}

Result<CheckReport> CheckRecord::finish() {
  if (const auto finished = finish_extras(); !finished) return finished.error();
  if (!settings_.max_contacts && report_.totals.unknown.frames.empty())
    report_.totals.hash = hash_.value();
  if (always_) report_.always = always_->counts();
  judge_findings();
  return std::move(report_);
}

Result<void> CheckRecord::finish_extras() {
  report_.patches = patches_.patches();
  report_.longest_patches = patches_.longest();
  if (inside_) {
    const std::vector<scene::Collider>& colliders = stage_.colliders;
    inside_->closed_colliders = static_cast<std::size_t>(std::count_if(
        colliders.begin(), colliders.end(),
        [](const scene::Collider& collider) { return collider.model.surface().is_closed(); }));
    report_.inside = std::move(*inside_);
  }
  if (!between_) return {};
  Result<BetweenReport> between = between_->report();
  if (!between) return between.error();
  report_.totals.between = std::move(*between);
  return {};
}

void CheckRecord::judge_findings() {
  const std::vector<Touch> touches = tally_.touches();
  const Findings found = findings_of(report_, touches);
  report_.verdict = judge(stage_.staged, found, settings_);
  jsonl_.totals(found, report_.verdict);
}

}  // namespace pelt::tools::check
