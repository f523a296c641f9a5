#include "tools/pelt/check/check_query.hpp"

#include "asset/message.hpp"
#include "scenes/takes.hpp"
#include "tools/pelt/check/frame_line.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pelt::tools::check {
namespace {

using Clock = std::chrono::steady_clock;

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

/// The work between two sums. `cut_short` of the result is always false.
QueryStats work_between(const QueryStats& before, const QueryStats& after) {
  QueryStats work;
  work.node_pairs = after.node_pairs - before.node_pairs;
  work.refits = after.refits - before.refits;
  work.posed_vertices = after.posed_vertices - before.posed_vertices;
  work.triangle_pairs = after.triangle_pairs - before.triangle_pairs;
  work.displacements = after.displacements - before.displacements;
  return work;
}

}  // namespace

Result<CheckPlan> CheckPlan::make(const scene::StagedScene& staged, const CheckSettings& settings,
                                  const CheckQuestion& question, bool writes_lines) {
  auto ignored = scenes::IgnoredPairs::make(scenes::characters_of(staged.scene), settings.ignore);
  if (!ignored) return ignored.error();
  CheckPlan plan = {
      staged, settings, question, writes_lines, settings.frames.frames(), std::move(*ignored), {}};
  if (!settings.self.asks_self()) return plan;
  auto filters = scene::make_self_filters(staged, settings.self.rules, settings.frames);
  if (!filters) return filters.error();
  plan.filters = std::move(*filters);
  return plan;
}

CheckQuery::CheckQuery(const CheckPlan& plan, std::uint32_t threads)
    : plan_(plan), pairs_(make_pairs(plan, threads)) {
  const auto& [staged, settings, question, writes_lines, frames, ignored, filters] = plan;
  if (filters) self_.emplace(staged.colliders, *filters, threads);
  if (settings.asks_inside) inside_.emplace(staged, ignored);
  if (settings.substeps) {
    between_.emplace(
        staged, *settings.substeps, ignored,
        BetweenTests{settings.self.asks_pairs(), filters ? &*filters : nullptr, threads});
    deviation_.emplace(staged);
  }
  if (settings.describes_contacts) details_.emplace(staged);
}

CheckQuery::PairQuery CheckQuery::make_pairs(const CheckPlan& plan, std::uint32_t threads) {
  const CheckSettings& settings = plan.settings;
  const std::span<const scene::Collider> colliders = plan.staged.colliders;
  if (settings.clearance) return ClearanceQuery(colliders, *settings.clearance);
  if (settings.budget) return BudgetQuery(colliders, *settings.budget);
  const auto tested = settings.self.asks_pairs() ? colliders : colliders.first(0);
  if (settings.method == methods::kOnDemand) return scene::SceneQuery::as_crowd(tested, threads);
  return scene::SceneQuery(tested, settings.method.make());
}

Result<void> CheckQuery::ask(std::size_t index, FrameAnswer& answer) {
  if (const auto asked = ask_frame(index, answer); !asked)
    return asset::prefixed(scene::frame_words(plan_.staged.scene, plan_.frames[index]),
                           asked.error());
  return {};
}

Result<void> CheckQuery::ask_frame(std::size_t index, FrameAnswer& answer) {
  answer.frame = plan_.frames[index];
  const QueryStats before = work();
  scene::sample_palettes(plan_.staged.scene, answer.frame, sample_scratch_, palettes_);
  if (const auto found = find_contacts(answer); !found) return found;
  if (const auto asked = ask_inside(answer); !asked) return asked;
  answer.ignored = take_ignored_out(plan_.ignored, plan_.staged, answer.found);
  if (const auto asked = ask_between(index, answer); !asked) return asked;
  if (const auto described = describe(answer); !described) return described;
  answer.work = work_between(before, work());
  if (plan_.writes_lines)
    answer.line = frame_line(plan_.staged, plan_.question, answer, details_ ? &*details_ : nullptr);
  return {};
}

/// Finds the contacts of the frame, including ignored ones.
Result<void> CheckQuery::find_contacts(FrameAnswer& answer) {
  Limits limits;
  if (plan_.settings.max_contacts) limits.max_contacts = *plan_.settings.max_contacts;
  const Clock::time_point begin = Clock::now();
  const auto find = [&](auto& query) -> Result<void> {
    if (const auto posed = query.set_palettes(palettes_); !posed) return posed;
    query.collide(self_ ? self_->limit_of_pairs(limits) : limits, answer.found);
    return {};
  };
  if (const auto found = std::visit(find, pairs_); !found) return found;
  if (inside_) unfiltered_ = answer.found;
  if (self_) {
    if (const auto posed = self_->set_palettes(palettes_); !posed) return posed;
    self_->collide(limits, answer.found);
    answer.left_out = self_->left_out();
  }
  answer.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (const auto* const budget = std::get_if<BudgetQuery>(&pairs_))
    answer.undecided.assign(budget->undecided().begin(), budget->undecided().end());
  return {};
}

/// Uses all contacts of pairs, including dropped and ignored ones.
Result<void> CheckQuery::ask_inside(FrameAnswer& answer) {
  if (!inside_) return {};
  if (const auto asked = inside_->ask(palettes_, unfiltered_); !asked) return asked;
  answer.inside.assign(inside_->pairs().begin(), inside_->pairs().end());
  return {};
}

/// The first frame, and the first one of a take, end no step.
Result<void> CheckQuery::ask_between(std::size_t index, FrameAnswer& answer) {
  answer.step.reset();
  if (!between_ || index == 0) return {};
  const scenes::Scene& scene = plan_.staged.scene;
  const std::uint32_t from = plan_.frames[index - 1];
  if (scenes::take_index(scene, from) != scenes::take_index(scene, answer.frame)) return {};
  StepAnswer& step = answer.step.emplace();
  if (const auto asked = between_->ask(from, answer.frame, palettes_, step); !asked) return asked;
  const auto deviation = deviation_->of_step(from, answer.frame, *plan_.settings.substeps);
  if (!deviation) return deviation.error();
  step.deviation = *deviation;
  return {};
}

Result<void> CheckQuery::describe(FrameAnswer& answer) {
  if (!details_) return {};
  if (const auto described = details_->describe(palettes_, answer.found); !described)
    return described;
  answer.patches = described_patches(answer.found, *details_);
  return {};
}

QueryStats CheckQuery::work() const {
  QueryStats work = std::visit([](const auto& query) { return query.work(); }, pairs_);
  if (self_) work += self_->work();
  if (inside_) work += inside_->work();
  return work;
}

}  // namespace pelt::tools::check
