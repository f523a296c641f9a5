#include "tools/pelt/check/verdict.hpp"

#include "scenes/names.hpp"
#include "tools/pelt/check/settings.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace pelt::tools::check {
namespace {

constexpr std::array<std::pair<std::string_view, FailOn>, 6> kNames = {
    {{"contact", FailOn::contact},
     {"between", FailOn::between},
     {"grown", FailOn::grown},
     {"new", FailOn::newly},
     {"unknown", FailOn::unknown},
     {"never", FailOn::never}}};

bool has_new(const TouchChanges& changes) {
  const auto is_new = [](const Worse& worse) { return worse.known == 0; };
  return std::any_of(changes.worse.begin(), changes.worse.end(), is_new);
}

bool has_new(const Comparison& comparison) {
  return !comparison.newly_held.empty() || has_new(comparison.touches) ||
         has_new(comparison.between);
}

bool fails(FailOn fail_on, const Findings& found, const std::optional<Comparison>& comparison) {
  switch (fail_on) {
    case FailOn::contact:
      return !found.touches.empty() || !found.held.empty() || !found.between().empty();
    case FailOn::between:
      return !found.between().empty();
    case FailOn::grown:
      return has_new(*comparison) || !comparison->touches.worse.empty() ||
             !comparison->between.worse.empty();
    case FailOn::newly:
      return has_new(*comparison);
    case FailOn::unknown:
      return !found.touches.empty() || !found.held.empty() || !found.totals.unknown.frames.empty();
    case FailOn::never:
      break;
  }
  return false;
}

/// The parts that exist in a scene's files but that options leave out of this check.
class LeftOutParts {
 public:
  explicit LeftOutParts(const scenes::Scene& scene) {
    for (const scenes::Character& character : scene.characters) {
      Names& names = models_[scene::as_json_holds(character.name)];
      for (const std::string& part : scenes::part_names(character.asset))
        names.parts.insert(scene::as_json_holds(part));
      for (const asset::Node& node : character.asset.nodes)
        names.nodes.insert(scene::as_json_holds(node.name));
    }
  }

  /// Whether the part is named after its node, or as "node:material".
  bool contains(const BodyName& body) const {
    const auto model = models_.find(body.model);
    if (model == models_.end() || model->second.parts.count(body.part) > 0) return false;
    const std::set<std::string>& nodes = model->second.nodes;
    return nodes.count(body.part) > 0 || nodes.count(body.part.substr(0, body.part.rfind(':'))) > 0;
  }

 private:
  struct Names {
    std::set<std::string> parts, nodes;
  };

  std::map<std::string, Names> models_;
};

/// New touches come first, because they fail most checks.
void sort_by_importance(std::vector<Worse>& worse) {
  std::stable_partition(worse.begin(), worse.end(),
                        [](const Worse& touch) { return touch.known == 0; });
}

TouchChanges compare_touches(const scene::StagedScene& staged, std::span<const Touch> touches,
                             const CheckBaseline::Touches& baseline) {
  TouchChanges changes;
  CheckBaseline::Touches rest = baseline;
  changes.known = rest.size();
  for (const Touch& touch : touches) {
    const CheckBaseline::TouchNames names = names_of(staged, touch);
    const std::uint64_t known = worst_of(baseline, names);
    if (touch.worst > known) changes.worse.push_back({touch, known});
    rest.erase(names);
  }
  sort_by_importance(changes.worse);
  const LeftOutParts left_out(staged.scene);
  for (const auto& [names, known] : rest) {
    const bool asked =
        !left_out.contains(names.first.body) && !left_out.contains(names.second.body);
    (asked ? changes.gone : changes.left_out).push_back({names, known});
  }
  return changes;
}

void compare_held(const scene::StagedScene& staged, std::span<const Held> held,
                  const CheckBaseline& baseline, Comparison& comparison) {
  std::set<CheckBaseline::HeldNames> rest = baseline.held();
  for (const Held& h : held) {
    const CheckBaseline::HeldNames names = names_of(staged, h);
    if (baseline.held().count(names) == 0) comparison.newly_held.push_back(h);
    rest.erase(names);
  }
  const LeftOutParts left_out(staged.scene);
  for (const CheckBaseline::HeldNames& names : rest) {
    if (!left_out.contains(names.inner) && !left_out.contains(names.outer))
      comparison.no_longer_held.push_back(names);
  }
}

/// Number of pairs of colliders that each frame compares; a collider and itself are a pair.
std::uint64_t bodies_compared(std::uint64_t colliders, const SelfChoice& self) {
  const std::uint64_t pairs = colliders < 2 ? 0 : colliders * (colliders - 1) / 2;
  return (self.asks_pairs() ? pairs : 0) + (self.asks_self() ? colliders : 0);
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
  comparison.touches = compare_touches(staged, found.touches, baseline.touches());
  comparison.between = compare_touches(staged, found.between(), baseline.touches_between());
  compare_held(staged, found.held, baseline, comparison);
  return comparison;
}

Verdict judge(const scene::StagedScene& staged, const Findings& found,
              const CheckSettings& settings) {
  Verdict verdict;
  verdict.fail_on = settings.fail_on;
  verdict.pairs_compared = bodies_compared(staged.colliders.size(), settings.self);
  if (settings.baseline) verdict.comparison = compare(staged, found, *settings.baseline);
  const bool may_pass = verdict.pairs_compared > 0 || settings.options.allow_empty;
  verdict.is_failed = !may_pass || fails(settings.fail_on, found, verdict.comparison);
  return verdict;
}

}  // namespace pelt::tools::check
