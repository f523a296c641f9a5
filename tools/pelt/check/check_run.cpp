#include "tools/pelt/check/check_run.hpp"

#include "scenes/ignored_pairs.hpp"
#include "scenes/takes.hpp"
#include "tools/pelt/check/budget_query.hpp"
#include "tools/pelt/check/clearance_query.hpp"
#include "tools/pelt/scene/contact_hash.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/self_query.hpp"

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
  if (settings.frame_to_keep) return frame == *settings.frame_to_keep;
  return frame == settings.frames.begin ||
         (report.worst_contacts > 0 && frame == report.worst_frame);
}

/// Removes ignored contacts, and pairs of colliders without other contacts. Returns the number of
/// removed contacts.
std::uint64_t take_ignored_out(const scenes::IgnoredPairs& ignored,
                               const scene::StagedScene& staged, scene::FrameContacts& found) {
  if (ignored.is_empty()) return 0;
  const std::size_t before = found.contacts.size();
  std::size_t end = 0;
  for (scene::FrameContacts::Pair& pair : found.pairs) {
    const std::span<Contact> contacts =
        std::span(found.contacts).subspan(pair.begin, pair.end - pair.begin);
    const std::size_t counted =
        ignored.keep_counted(staged.character_of(pair.a), staged.character_of(pair.b), contacts);
    std::copy_n(contacts.begin(), counted,
                found.contacts.begin() + static_cast<std::ptrdiff_t>(end));
    pair.begin = end;
    pair.end = end += counted;
  }
  found.contacts.resize(end);
  std::erase_if(found.pairs, [](const scene::FrameContacts::Pair& p) { return p.begin == p.end; });
  return before - end;
}

/// Optional queries of a frame in addition to its contacts.
class ExtraQueries {
 public:
  /// All arguments must outlive this.
  ExtraQueries(const scene::StagedScene& staged, const CheckSettings& settings,
               const scenes::IgnoredPairs& ignored, const scene::SelfQuery* self,
               const TouchTally& empty_tally)
      : scene_(staged.scene) {
    if (settings.asks_inside) inside_.emplace(staged, ignored);
    const BetweenTests tests = {settings.self.asks_pairs(), self ? &self->filters() : nullptr};
    if (settings.substeps)
      between_.emplace(staged, *settings.substeps, ignored, tests, empty_tally);
    if (!settings.describes_contacts) return;
    details_.emplace(staged);
    patches_.emplace(staged);
  }

  /// `found` has all contacts of pairs, including dropped and ignored ones.
  Result<void> ask_inside(std::uint32_t frame, const scene::Palettes& palettes,
                          const scene::FrameContacts& found) {
    if (!inside_) return {};
    if (const auto asked = inside_->ask(palettes, found); !asked) return asked;
    insides_.add(frame, inside_->pairs(), scenes::take_index(scene_, frame));
    return {};
  }

  /// `found` has the counted contacts.
  Result<void> ask_between(std::uint32_t frame, const scene::Palettes& palettes,
                           const scene::FrameContacts& found) {
    return between_ ? between_->ask(frame, palettes, found) : Result<void>();
  }

  Result<void> describe(std::uint32_t frame, const scene::Palettes& palettes,
                        const scene::FrameContacts& found) {
    if (!details_) return {};
    if (const auto described = details_->describe(palettes, found); !described) return described;
    patches_->add(frame, found, *details_);
    return {};
  }

  FrameExtras of_frame() const {
    return {.details = details_ ? &*details_ : nullptr,
            .inside = inside_ ? &*inside_ : nullptr,
            .step = between_ ? between_->step() : nullptr};
  }

  Result<void> report(CheckReport& report) {
    if (patches_) {
      report.patches = patches_->patches();
      report.longest_patches = patches_->longest();
    }
    if (inside_) {
      report.inside = insides_;
      report.inside->closed_colliders = inside_->closed_count();
      report.totals.work += inside_->work();
    }
    if (!between_) return {};
    Result<BetweenReport> between = between_->report();
    if (!between) return between.error();
    report.totals.between = std::move(*between);
    return {};
  }

 private:
  const scenes::Scene& scene_;
  std::optional<InsideQuery> inside_;
  InsideTally insides_;
  std::optional<BetweenCheck> between_;
  std::optional<ContactDetails> details_;
  std::optional<PatchTally> patches_;
};

/// Returns nullopt if bodies are not tested against themselves.
Result<std::optional<scene::SelfQuery>> make_self_query(const scene::StagedScene& staged,
                                                        const CheckSettings& settings) {
  if (!settings.self.asks_self()) return std::optional<scene::SelfQuery>();
  auto filters = scene::make_self_filters(staged, settings.self.rules, settings.frames);
  if (!filters) return filters.error();
  return std::optional<scene::SelfQuery>(std::in_place, staged.colliders, std::move(*filters));
}

/// Returns nullopt if --self-always is chosen, or if there are too few frames or contacts to
/// suggest it.
std::optional<AlwaysTally> make_always_tally(const scene::StagedScene& staged,
                                             const CheckSettings& settings) {
  constexpr std::size_t kFewestFrames = 8;
  const std::size_t frames = settings.frames.frames().size();
  if (!settings.self.asks_self() || settings.self.is_always_chosen || settings.max_contacts ||
      frames < kFewestFrames)
    return std::nullopt;
  return AlwaysTally(staged, frames, kSuggestedShare);
}

Result<void> ask_self(std::optional<scene::SelfQuery>& query, const scene::Palettes& palettes,
                      const CollideOptions& options, scene::FrameContacts& found) {
  if (!query) return {};
  if (const auto posed = query->set_palettes(palettes); !posed) return posed;
  query->collide(options, found);
  return {};
}

/// Null for queries whose answers are complete.
template <typename Query>
const BudgetQuery* budget_of(const Query&) {
  return nullptr;
}
const BudgetQuery* budget_of(const BudgetQuery& query) { return &query; }

void count_unknown(std::uint32_t frame, const BudgetQuery* query, UnknownTotals& totals) {
  if (query == nullptr || query->undecided().empty()) return;
  totals.frames.push_back(frame);
  std::uint64_t pairs = 0;
  for (const Undecided& undecided : query->undecided()) {
    pairs += undecided.pairs;
    totals.resolution = std::max(totals.resolution, undecided.resolution);
  }
  totals.most_pairs = std::max(totals.most_pairs, pairs);
}

/// `Query` is SceneQuery, ClearanceQuery or BudgetQuery. Precondition: `tally` is
/// empty.
template <typename Query>
Result<CheckReport> run_query(Query& query, const scene::StagedScene& staged,
                              const CheckSettings& settings, TouchTally& tally,
                              JsonlWriter& jsonl) {
  const auto ignored =
      scenes::IgnoredPairs::make(scenes::characters_of(staged.scene), settings.ignore);
  if (!ignored) return ignored.error();
  CheckReport report;
  report.worst_frame = settings.frames.begin;
  CollideOptions options;
  if (settings.max_contacts) options.max_contacts = *settings.max_contacts;
  scene::FrameContacts found, unfiltered;
  scene::ContactHash hash;
  std::optional<AlwaysTally> always = make_always_tally(staged, settings);
  Result<std::optional<scene::SelfQuery>> self = make_self_query(staged, settings);
  if (!self) return self.error();
  ExtraQueries extras(staged, settings, *ignored, *self ? &**self : nullptr, tally);
  const auto ask = [&](const scene::Palettes& palettes) -> Result<QueryStats> {
    if (const auto posed = query.set_palettes(palettes); !posed) return posed.error();
    query.collide(*self ? (*self)->limit_of_pairs(options) : options, found);
    if (settings.asks_inside && *self) unfiltered = found;
    if (const auto asked = ask_self(*self, palettes, options, found); !asked) return asked.error();
    return QueryStats{};  // the queries count their work themselves
  };
  const auto record = [&](std::uint32_t frame, const scene::Palettes& palettes) -> Result<void> {
    const auto asked_inside = extras.ask_inside(frame, palettes, *self ? unfiltered : found);
    if (!asked_inside) return asked_inside;
    report.totals.ignored += take_ignored_out(*ignored, staged, found);
    if (*self) report.totals.left_out += (*self)->left_out();
    count_frame(staged.scene, frame, found, report);
    count_unknown(frame, budget_of(query), report.totals.unknown);
    tally.add(frame, found);
    if (always) always->add(found);
    hash.add(frame, found);
    if (const auto asked = extras.ask_between(frame, palettes, found); !asked) return asked;
    if (const auto asked = extras.describe(frame, palettes, found); !asked) return asked;
    FrameExtras of_frame = extras.of_frame();
    of_frame.budget = budget_of(query);
    if (*self) of_frame.left_out = &(*self)->left_out();
    jsonl.frame(frame, found, of_frame);
    if (is_to_be_kept(frame, settings, report)) report.kept = {frame, found};
    return {};
  };
  Result<scene::FrameCosts> costs = scene::run_frames(staged.scene, settings.frames, {ask, record});
  if (!costs) return costs.error();
  report.frame_seconds = std::move(costs->seconds);
  report.totals.work = query.work();
  if (*self) report.totals.work += (*self)->work();
  if (const auto reported = extras.report(report); !reported) return reported.error();
  if (!settings.max_contacts && report.totals.unknown.frames.empty())
    report.totals.hash = hash.value();
  if (always) report.always = always->counts();
  return report;
}

/// Number of pairs of colliders that each frame compares; a collider and itself are a pair.
std::uint64_t bodies_compared(std::uint64_t colliders, const SelfChoice& self) {
  const std::uint64_t pairs = colliders < 2 ? 0 : colliders * (colliders - 1) / 2;
  return (self.asks_pairs() ? pairs : 0) + (self.asks_self() ? colliders : 0);
}

/// Sets the totals, which are known after the last frame.
void conclude(const scene::StagedScene& staged, const CheckSettings& settings,
              const TouchTally& tally, CheckReport& report, JsonlWriter& jsonl) {
  const std::vector<Touch> touches = tally.touches();
  Findings found = {touches};
  if (report.inside) found.held = report.inside->held;
  if (report.totals.between) found.between = report.totals.between->touches;
  found.frames_unknown = report.totals.unknown.frames.size();
  const CheckBaseline* const baseline = settings.baseline ? &*settings.baseline : nullptr;
  report.verdict = judge(staged, found,
                         {settings.fail_on, settings.allows_empty, baseline,
                          bodies_compared(staged.colliders.size(), settings.self)});
  jsonl.totals(report.totals, found, report.verdict);
}

Result<CheckReport> run_chosen(const scene::StagedScene& staged, const CheckSettings& settings,
                               TouchTally& tally, JsonlWriter& jsonl) {
  if (settings.clearance) {
    ClearanceQuery query(staged.colliders, *settings.clearance);
    return run_query(query, staged, settings, tally, jsonl);
  }
  if (settings.budget) {
    BudgetQuery query(staged.colliders, *settings.budget);
    return run_query(query, staged, settings, tally, jsonl);
  }
  const std::span<const scene::Collider> none;
  scene::SceneQuery query(settings.self.asks_pairs() ? staged.colliders : none, settings.method);
  return run_query(query, staged, settings, tally, jsonl);
}

}  // namespace

Result<CheckReport> run_check(const scene::StagedScene& staged, const CheckSettings& settings,
                              TouchTally& tally, JsonlWriter& jsonl) {
  Result<CheckReport> report = run_chosen(staged, settings, tally, jsonl);
  if (report) conclude(staged, settings, tally, *report, jsonl);
  return report;
}

}  // namespace pelt::tools::check
