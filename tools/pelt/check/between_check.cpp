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
                           TouchTally tally)
    : staged_(staged), tally_(std::move(tally)) {
  report_.substeps = substeps;
}

const StepContacts* BetweenCheck::add(const FrameAnswer& answer) {
  const bool has_contacts = [&] {
    if (!answer.step) return false;
    const StepAnswer& step = *answer.step;
    ++report_.steps;
    report_.work += step.work;
    report_.step_seconds.push_back(step.seconds);
    if (step.deviation.distance > report_.deviation.distance) report_.deviation = step.deviation;
    step_ = contacts_of_step(step, at_start_, answer.found);
    return !step_.firsts.empty();
  }();
  at_start_ = answer.found;
  if (!has_contacts) return nullptr;
  add_contacts();
  return &step_;
}

void BetweenCheck::add_contacts() {
  const std::uint64_t contacts = step_.between.contacts.size();
  report_.contacts += contacts;
  report_.found.push_back({step_.from, step_.to, contacts, earliest_of(step_)});
  tally_.add(step_.from, step_.between);
  hash_.add(step_.from, step_.between);
}

Result<BetweenReport> BetweenCheck::report() {
  report_.touches = tally_.touches();
  report_.joints = tally_.joints();
  report_.parts = tally_.parts();
  report_.hash = hash_.value();
  const auto& [distance, collider, vertex, from, to] = report_.deviation;
  if (distance == 0) return report_;
  report_.falls = {{report_.substeps, distance}};
  ChordDeviation deviations(staged_);
  for (const std::uint32_t more : {2 * report_.substeps, 4 * report_.substeps}) {
    const auto deviation = deviations.of_step(from, to, more);
    if (!deviation) return deviation.error();
    report_.falls.push_back({more, deviation->distance});
  }
  return report_;
}

}  // namespace pelt::tools::check
