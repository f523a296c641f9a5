#include "tools/pelt/check/steps.hpp"

#include "tools/pelt/check/step_query.hpp"

#include <algorithm>
#include <utility>

namespace pelt::tools::check {
namespace {

/// Whether the contacts of a frame contain this one. O(log n) in pairs and contacts.
bool contains(const scene::FrameContacts& found, const FoundInStep& touch) {
  const auto pair = std::lower_bound(
      found.pairs.begin(), found.pairs.end(), std::pair(touch.a, touch.b),
      [](const scene::FrameContacts::Pair& p, const std::pair<std::uint32_t, std::uint32_t>& key) {
        return std::pair(p.a, p.b) < key;
      });
  if (pair == found.pairs.end() || pair->a != touch.a || pair->b != touch.b) return false;
  const std::span<const Contact> contacts = found.of(*pair);
  return std::binary_search(contacts.begin(), contacts.end(), touch.contact);
}

/// Returns the contacts of a step. `at_start` and `at_end` are the counted contacts of its frames.
/// Pairs that touch at the start of a piece also touch in the piece before, or at the start of the
/// step, so `step` and `at_start` have all contacts. O(n log n) in contacts.
StepContacts contacts_of_step(const StepAnswer& step, const scene::FrameContacts& at_start,
                              const scene::FrameContacts& at_end) {
  StepContacts contacts;
  contacts.from = step.from;
  contacts.to = step.to;
  contacts.contacts = at_start.contacts.size();
  for (const FoundInStep& touch : step.found) {
    if (contains(at_start, touch)) continue;
    ++contacts.contacts;
    if (contains(at_end, touch)) continue;
    contacts.between.add(touch.a, touch.b, touch.contact);
    contacts.firsts.push_back(touch.first);
  }
  return contacts;
}

FoundInStep earliest_of(const StepContacts& step) {
  const std::size_t index = step.earliest();
  for (const scene::FrameContacts::Pair& pair : step.between.pairs) {
    if (index < pair.end) return {pair.a, pair.b, step.between.contacts[index], step.firsts[index]};
  }
  return {};
}

}  // namespace

std::size_t StepContacts::earliest() const {
  const auto first = std::min_element(
      firsts.begin(), firsts.end(),
      [](const FirstTouch& x, const FirstTouch& y) { return x.seconds < y.seconds; });
  return static_cast<std::size_t>(first - firsts.begin());
}

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
