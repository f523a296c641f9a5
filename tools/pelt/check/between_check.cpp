#include "tools/pelt/check/between_check.hpp"

#include <utility>

namespace pelt::tools::check {
namespace {

StepBetween::Earliest earliest_of(const StepContacts& step) {
  const std::size_t index = step.earliest();
  for (const scene::FrameContacts::Pair& pair : step.between.pairs) {
    if (index < pair.end) return {pair.a, pair.b, step.between.contacts[index], step.firsts[index]};
  }
  return {};
}

}  // namespace

BetweenCheck::BetweenCheck(const scene::StagedScene& staged, std::uint32_t substeps,
                           const scenes::IgnoredPairs& ignored, const BetweenTests& tests,
                           TouchTally tally)
    : query_(staged, substeps, ignored, tests), deviation_(staged), tally_(std::move(tally)) {
  report_.substeps = substeps;
}

Result<void> BetweenCheck::ask(std::uint32_t frame, const scene::Palettes& palettes,
                               const scene::FrameContacts& found) {
  if (const auto asked = query_.ask(frame, palettes, found); !asked) return asked;
  const StepContacts* const step = query_.step();
  if (step == nullptr) return {};
  ++report_.steps;
  if (!step->firsts.empty()) add(*step);
  const auto deviation = deviation_.of_step(step->from, step->to, report_.substeps);
  if (!deviation) return deviation.error();
  if (deviation->distance > report_.deviation.distance) report_.deviation = *deviation;
  return {};
}

void BetweenCheck::add(const StepContacts& step) {
  const std::uint64_t contacts = step.between.contacts.size();
  report_.contacts += contacts;
  report_.found.push_back({step.from, step.to, contacts, earliest_of(step)});
  tally_.add(step.from, step.between);
  hash_.add(step.from, step.between);
}

const StepContacts* BetweenCheck::step() const {
  const StepContacts* const step = query_.step();
  return step != nullptr && !step->firsts.empty() ? step : nullptr;
}

Result<BetweenReport> BetweenCheck::report() {
  report_.touches = tally_.touches();
  report_.joints = tally_.joints();
  report_.parts = tally_.parts();
  report_.hash = hash_.value();
  report_.work = query_.work();
  report_.step_seconds = query_.step_seconds();
  const auto& [distance, collider, vertex, from, to] = report_.deviation;
  if (distance == 0) return report_;
  report_.falls = {{report_.substeps, distance}};
  for (const std::uint32_t more : {2 * report_.substeps, 4 * report_.substeps}) {
    const auto deviation = deviation_.of_step(from, to, more);
    if (!deviation) return deviation.error();
    report_.falls.push_back({more, deviation->distance});
  }
  return report_;
}

}  // namespace pelt::tools::check
