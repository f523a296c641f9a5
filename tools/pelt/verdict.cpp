#include "tools/pelt/verdict.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pelt::tools {
namespace {

constexpr std::array<std::pair<std::string_view, FailOn>, 4> kNames = {
    {{"contact", FailOn::contact},
     {"grown", FailOn::grown},
     {"new", FailOn::newly},
     {"never", FailOn::never}}};

bool fails(FailOn fail_on, std::span<const Touch> touches, std::span<const Worse> worse) {
  const auto is_new = [](const Worse& w) { return w.known == 0; };
  switch (fail_on) {
    case FailOn::contact:
      return !touches.empty();
    case FailOn::grown:
      return !worse.empty();
    case FailOn::newly:
      return std::any_of(worse.begin(), worse.end(), is_new);
    case FailOn::never:
      break;
  }
  return false;
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

std::vector<Worse> find_worse(const scenes::Scene& scene, std::span<const Touch> touches,
                              const KnownTouches& known) {
  std::vector<Worse> worse;
  for (const Touch& touch : touches) {
    const std::uint64_t then = known.worst(touch_name(scene, touch.a), touch_name(scene, touch.b));
    if (touch.worst > then) worse.push_back({touch, then});
  }
  return worse;
}

Verdict judge(const scenes::Scene& scene, std::span<const Touch> touches, const KnownTouches* known,
              FailOn fail_on) {
  Verdict verdict;
  verdict.fail_on = fail_on;
  verdict.has_baseline = known != nullptr;
  if (known != nullptr) verdict.worse = find_worse(scene, touches, *known);
  verdict.is_failed = fails(fail_on, touches, verdict.worse);
  return verdict;
}

}  // namespace pelt::tools
