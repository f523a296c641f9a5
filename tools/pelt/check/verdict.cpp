#include "tools/pelt/check/verdict.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace pelt::tools::check {
namespace {

constexpr std::array<std::pair<std::string_view, FailOn>, 4> kNames = {
    {{"contact", FailOn::contact},
     {"grown", FailOn::grown},
     {"new", FailOn::newly},
     {"never", FailOn::never}}};

bool has_new(const Comparison& comparison) {
  const auto is_new = [](const Worse& worse) { return worse.known == 0; };
  return !comparison.newly_held.empty() ||
         std::any_of(comparison.worse.begin(), comparison.worse.end(), is_new);
}

bool fails(FailOn fail_on, const Findings& found, const std::optional<Comparison>& comparison) {
  switch (fail_on) {
    case FailOn::contact:
      return !found.touches.empty() || !found.held.empty();
    case FailOn::grown:
      return has_new(*comparison) || !comparison->worse.empty();
    case FailOn::newly:
      return has_new(*comparison);
    case FailOn::never:
      break;
  }
  return false;
}

void compare_touches(const scenes::Scene& scene, std::span<const Touch> touches,
                     const CheckBaseline& baseline, Comparison& comparison) {
  std::map<CheckBaseline::TouchNames, std::uint64_t> rest = baseline.touches();
  comparison.known_touches = rest.size();
  for (const Touch& touch : touches) {
    const CheckBaseline::TouchNames names = names_of(scene, touch);
    const std::uint64_t known = baseline.worst(names);
    if (touch.worst > known) comparison.worse.push_back({touch, known});
    rest.erase(names);
  }
  for (const auto& [names, known] : rest) comparison.gone.push_back({names, known});
}

void compare_held(const scene::StagedScene& staged, std::span<const Held> held,
                  const CheckBaseline& baseline, Comparison& comparison) {
  std::set<CheckBaseline::HeldNames> rest = baseline.held();
  for (const Held& h : held) {
    const CheckBaseline::HeldNames names = {body_name(staged.scene, staged.colliders[h.inner]),
                                            body_name(staged.scene, staged.colliders[h.outer])};
    if (baseline.held().count(names) == 0) comparison.newly_held.push_back(h);
    rest.erase(names);
  }
  comparison.no_longer_held.assign(rest.begin(), rest.end());
}

}  // namespace

std::optional<FailOn> find_fail_on(std::string_view name) {
  for (const auto& [known, fail_on] : kNames) {
    if (known == name) return fail_on;
  }
  return std::nullopt;
}

const char* name_of(FailOn fail_on) {
  return kNames[static_cast<std::size_t>(fail_on)].first.data();
}

Comparison compare(const scene::StagedScene& staged, const Findings& found,
                   const CheckBaseline& baseline) {
  Comparison comparison;
  comparison.notes.assign(baseline.notes().begin(), baseline.notes().end());
  compare_touches(staged.scene, found.touches, baseline, comparison);
  compare_held(staged, found.held, baseline, comparison);
  return comparison;
}

Verdict judge(const scene::StagedScene& staged, const Findings& found,
              const CheckBaseline* baseline, FailOn fail_on) {
  Verdict verdict;
  verdict.fail_on = fail_on;
  if (baseline != nullptr) verdict.comparison = compare(staged, found, *baseline);
  verdict.is_failed = fails(fail_on, found, verdict.comparison);
  return verdict;
}

}  // namespace pelt::tools::check
