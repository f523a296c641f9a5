#include "tools/pelt/check/summary.hpp"

#include "scenes/takes.hpp"
#include "text/format.hpp"
#include "text/printable.hpp"
#include "tools/pelt/check/jsonl.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <iomanip>
#include <tuple>

namespace pelt::tools::check {
namespace {

/// Width of a column of names.
template <typename Row>
int width_of(std::span<const Row> rows, std::string Row::*column = &Row::a) {
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, (row.*column).size());
  return static_cast<int>(width);
}

/// Contacts by joints or by parts.
struct RowList {
  const char* title;
  const std::vector<TouchTally::Row>& rows;
  std::uint64_t contacts = 0;  ///< in all
  const char* noun = "frame";  ///< what the rows count, and number from 0
};

/// Prints the contacts of each row, its share of all contacts, and its worst frame.
void print_rows(const RowList& list, const scenes::Scene& scene, const ListLength& length,
                std::ostream& out) {
  out << '\n' << list.title << '\n';
  const std::span<const TouchTally::Row> shown = length.shown(list.rows);
  const int width = width_of(shown), width_b = width_of(shown, &TouchTally::Row::b);
  const int clip_width = width_of(shown, &TouchTally::Row::clip);
  for (const TouchTally::Row& row : shown) {
    const double percent =
        100.0 * static_cast<double>(row.contacts) / static_cast<double>(list.contacts);
    out << std::right << std::setw(12) << text::with_commas(row.contacts) << std::setw(6)
        << text::fixed(percent, 1) << " %  " << std::left;
    if (clip_width > 0) out << std::setw(clip_width) << row.clip << "  ";
    out << std::setw(width) << row.a << "  " << std::setw(width_b) << row.b << "  in "
        << text::counted(row.frames, list.noun) << ", worst " << list.noun << ' '
        << scenes::frame_in_take(scene, row.worst_frame) << '\n';
  }
  length.print_rest(list.rows.size(), out);
}

constexpr const char* kRepeated = "";  // label of the lines of a list

std::string seconds_words(double seconds) { return text::fixed(seconds, 4) + " s"; }

/// "edge 1 of triangle 12 of knight 0"
std::string feature_words(const scene::StagedScene& staged, std::uint32_t collider,
                          std::uint32_t triangle, const Feature& feature) {
  std::string text = kFeatureNames[static_cast<std::size_t>(feature.kind)];
  if (feature.kind != FeatureKind::face) text.append(" ").append(std::to_string(feature.number));
  return text + " of triangle " + std::to_string(triangle) + " of " +
         scene::collider_name(staged, staged.colliders[collider]);
}

std::string earliest_words(const scene::StagedScene& staged, const StepBetween& found) {
  const auto& [a, b, contact, first] = found.earliest;
  return seconds_words(first.seconds) + ", " +
         feature_words(staged, a, contact.triangle_a, first.a) + ", " +
         feature_words(staged, b, contact.triangle_b, first.b);
}

/// Prints the steps with the most contacts between their frames first.
void print_steps(const scene::StagedScene& staged, const BetweenReport& report,
                 const ListLength& length, std::ostream& out) {
  std::vector<StepBetween> steps = report.found;
  std::stable_sort(steps.begin(), steps.end(), [](const StepBetween& x, const StepBetween& y) {
    return x.contacts > y.contacts;
  });
  for (const StepBetween& step : length.shown(steps)) {
    out << std::right << std::setw(12) << text::with_commas(step.contacts) << "  from "
        << scene::frame_words(staged.scene, step.from) << ", first at "
        << earliest_words(staged, step) << '\n';
  }
  length.print_rest(steps.size(), out);
}

void print_deviation(const scene::StagedScene& staged, const BetweenReport& report,
                     std::ostream& out) {
  scene::label(out, "straight");
  if (report.falls.empty()) {
    out << "vertices do not deviate from straight lines in the middle of any piece\n";
    return;
  }
  out << "vertices deviate at most " << text::fixed(report.deviation.distance, 6)
      << " from straight lines (middle of a piece, from "
      << scene::frame_words(staged.scene, report.deviation.from) << ", "
      << scene::collider_name(staged, staged.colliders[report.deviation.collider]) << ")\n";
  scene::label(out, kRepeated) << "in this step";
  const char* separator = ": ";
  for (const BetweenReport::Fall& fall : report.falls) {
    out << separator << text::fixed(fall.distance, 6) << " with --substeps " << fall.substeps;
    separator = ", ";
  }
  out << '\n';
}

/// Prints the contacts between frames, the worst steps, and the deviation from straight lines.
void print_between(const scene::StagedScene& staged, const BetweenReport& report,
                   const ListLength& length, std::ostream& out) {
  scene::label(out, "between");
  if (report.steps == 0) {
    out << "not tested: --between needs two frames of one clip, and there is only one frame\n";
    return;
  }
  if (report.contacts == 0) {
    out << "no pair touches between frames only, in " << text::counted(report.steps, "step")
        << '\n';
  } else {
    out << text::counted(report.contacts, "pair")
        << (report.contacts == 1 ? " touches in " : " touch in ")
        << text::counted(report.found.size(), "step") << " at neither end; first at "
        << seconds_words(report.found.front().earliest.first.seconds)
        << scene::clip_words(staged.scene, report.found.front().from) << '\n';
    print_steps(staged, report, length, out);
  }
  print_deviation(staged, report, out);
}

/// Prints the parts and the joints that touch between frames. Precondition: some do.
void print_touching_between(const scenes::Scene& scene, const BetweenReport& report,
                            const ListLength& length, std::ostream& out) {
  if (scene::has_many_parts(scene))
    print_rows({"parts that touch between frames", report.parts, report.contacts, "step"}, scene,
               length, out);
  print_rows({"joints that touch between frames", report.joints, report.contacts, "step"}, scene,
             length, out);
}

void print_costs_between(const BetweenReport& report, std::ostream& out) {
  if (report.steps == 0) return;
  scene::label(out, "steps") << "median "
                             << text::fixed(1e3 * output::median(report.step_seconds), 3)
                             << " ms, mean "
                             << text::fixed(1e3 * output::mean(report.step_seconds), 3)
                             << " ms per step\n";
}

/// "0.667 s"
std::string seconds_of(const scenes::Scene& scene, std::uint32_t frame) {
  return text::fixed(scenes::frame_time(scene, frame), 3) + " s";
}

void print_contacts(const scenes::Scene& scene, const CheckSettings& settings,
                    const CheckReport& report, std::ostream& out) {
  const CheckTotals& totals = report.totals;
  if (report.verdict.pairs_compared == 0) {
    scene::label(out, "contact") << "nothing was compared\n";
    return;
  }
  if (totals.contacts == 0) {
    scene::label(out, "contact") << "none in " << text::counted(totals.frames, "frame") << '\n';
    return;
  }
  scene::label(out, "contact") << "in " << text::with_commas(totals.frames_in_contact) << " of "
                               << text::counted(totals.frames, "frame") << ": "
                               << scene::frame_runs(scene, report.frames_in_contact,
                                                    settings.frames.stride)
                               << '\n';
  scene::label(out, "worst") << scene::frame_words(scene, report.worst_frame) << " ("
                             << seconds_of(scene, report.worst_frame)
                             << "): " << text::counted(report.worst_contacts, "contact") << '\n';
  scene::label(out, "contacts") << text::with_commas(totals.contacts) << " in all"
                                << (settings.max_contacts ? ", limited by the options" : "")
                                << '\n';
}

/// Prints whether bodies are tested against themselves.
void print_self(const CheckSettings& settings, std::size_t colliders, std::ostream& out) {
  if (!settings.self.asks_self()) return;
  const char* const body = settings.granularity == scene::Granularity::part ? "part" : "instance";
  scene::label(out, "self");
  if (colliders == 1)
    out << "the " << body << " is tested against itself\n";
  else if (settings.self.asks_pairs())
    out << "each " << body << " is also tested against itself\n";
  else
    out << "each " << body << " is tested against itself only\n";
}

/// Prints how many contacts of bodies with themselves the filters have left out.
void print_left_out(const LeftOut& left_out, const scene::SelfRules& rules, std::ostream& out) {
  if (left_out.total() == 0) return;
  scene::label(out, "dropped") << text::counted(left_out.total(), "self-contact");
  const char* separator = ": ";
  const auto print = [&](std::uint64_t count, const std::string& option) {
    if (count == 0) return;
    out << separator << text::with_commas(count) << " by " << option;
    separator = ", ";
  };
  print(left_out.rings, "--self-rings " + std::to_string(rules.rings));
  print(left_out.at_rest, "--self-at-rest");
  print(left_out.always, "--self-always");
  print(left_out.joints, "--self-near-joints");
  out << '\n';
}

/// Suggests --self-always if it would drop at least a third of the contacts of characters with
/// themselves.
void print_always(const AlwaysCounts& counts, std::ostream& out) {
  const auto& [contacts, always] = counts;
  if (always == 0 || 3 * always < contacts) return;
  scene::label(out, "note") << text::with_commas(always) << " of "
                            << text::counted(contacts, "self-contact")
                            << " are in nearly every frame: --self-always " << kSuggestedShare
                            << " drops them\n";
}

/// Prints the clips in contact, those with the most contacts of one frame first.
void print_takes(const scenes::Scene& scene, const std::vector<TakeTotals>& takes,
                 const ListLength& length, std::ostream& out) {
  std::vector<TakeTotals> in_contact = takes;
  std::erase_if(in_contact, [](const TakeTotals& take) { return take.contacts == 0; });
  std::stable_sort(in_contact.begin(), in_contact.end(),
                   [](const TakeTotals& a, const TakeTotals& b) { return a.worst > b.worst; });
  scene::label(out, "clips") << text::with_commas(in_contact.size()) << " of "
                             << text::counted(takes.size(), "checked clip") << " in contact\n";
  for (const TakeTotals& take : length.shown(in_contact)) {
    out << std::right << std::setw(12) << text::with_commas(take.worst) << "  "
        << scene::frame_words(scene, take.worst_frame) << ", in contact in "
        << text::with_commas(take.frames_in_contact) << " of "
        << text::counted(take.frames, "frame") << '\n';
  }
  length.print_rest(in_contact.size(), out);
}

void print_touching(const scenes::Scene& scene, const CheckReport& report, const TouchTally& tally,
                    const ListLength& length, std::ostream& out) {
  const std::uint64_t contacts = report.totals.contacts;
  const bool has_between = report.totals.between && report.totals.between->contacts > 0;
  if (contacts > 0) {
    if (scene::has_many_parts(scene))
      print_rows({"parts that touch", tally.parts(), contacts}, scene, length, out);
    print_rows({"joints that touch", tally.joints(), contacts}, scene, length, out);
  }
  if (has_between) print_touching_between(scene, *report.totals.between, length, out);
  if (contacts > 0 || has_between) out << '\n';
}

std::string held_words(const scene::StagedScene& staged, const Held& held) {
  return scene::collider_name(staged, staged.colliders[held.inner]) + " is contained in " +
         scene::collider_name(staged, staged.colliders[held.outer]) + " in " +
         text::counted(held.frames, "frame") + ", first " +
         scene::frame_words(staged.scene, held.first_frame);
}

void print_held(const scene::StagedScene& staged, const char* name, std::span<const Held> held,
                const ListLength& length, std::ostream& out) {
  for (const Held& one : length.shown(held))
    scene::label(out, name) << held_words(staged, one) << '\n';
  length.print_rest(held.size(), out);
}

void print_worse(const scene::StagedScene& staged, std::span<const Worse> worse,
                 const ListLength& length, std::ostream& out) {
  for (const auto& [touch, known] : length.shown(worse)) {
    out << std::right << std::setw(12) << text::with_commas(touch.worst) << " ("
        << (known == 0 ? "new" : "was " + text::with_commas(known)) << ")  "
        << scene::frame_words(staged.scene, touch.worst_frame) << "  " << touch_words(staged, touch)
        << '\n';
  }
  length.print_rest(worse.size(), out);
}

/// Prints the touches of the baseline that this check did not find.
void print_gone(const Comparison& comparison, std::ostream& out) {
  const std::size_t touches = comparison.touches.gone.size() + comparison.between.gone.size();
  const std::size_t held = comparison.no_longer_held.size();
  if (touches + held == 0) return;
  scene::label(out, "gone") << text::with_commas(touches) << " of "
                            << text::with_commas(comparison.touches.known +
                                                 comparison.between.known)
                            << " known touches";
  if (held > 0)
    out << ", and " << text::with_commas(held)
        << (held == 1 ? " known contained body" : " known contained bodies");
  // With other settings, touches may be missing for another reason.
  out << (comparison.notes.empty() ? ": write a new baseline\n" : "\n");
}

/// Returns the number of touches that are not in the baseline.
std::size_t new_touches(const TouchChanges& changes) {
  return static_cast<std::size_t>(
      std::count_if(changes.worse.begin(), changes.worse.end(),
                    [](const Worse& worse) { return worse.known == 0; }));
}

/// Prints how many touches are new, have grown, or are as in the baseline.
void print_changes(const TouchChanges& changes, const char* where, std::ostream& out) {
  const std::size_t fresh = new_touches(changes), grown = changes.worse.size() - fresh;
  const std::size_t as_known =
      changes.known - changes.gone.size() - changes.left_out.size() - grown;
  scene::label(out, "baseline") << text::with_commas(fresh) << " new, " << text::with_commas(grown)
                                << " grown, " << text::with_commas(as_known) << " as known" << where
                                << '\n';
}

void print_left_out_touches(const Comparison& comparison, std::ostream& out) {
  const std::size_t count = comparison.touches.left_out.size() + comparison.between.left_out.size();
  if (count == 0) return;
  scene::label(out, "left out") << text::with_commas(count) << " of "
                                << text::with_commas(comparison.touches.known +
                                                     comparison.between.known)
                                << " known touches, of parts that this check leaves out\n";
}

/// Prints the differences from the baseline.
void print_comparison(const scene::StagedScene& staged, const CheckSettings& settings,
                      const Comparison& comparison, const ListLength& length, std::ostream& out) {
  for (const std::string& note : comparison.notes)
    scene::label(out, "note") << text::printable(note) << '\n';
  const TouchChanges& touches = comparison.touches;
  const std::size_t fresh = new_touches(touches);
  print_changes(touches, "", out);
  const std::span<const Worse> worse = touches.worse;
  print_worse(staged, worse.first(fresh), length, out);
  print_held(staged, "new", comparison.newly_held, length, out);
  print_worse(staged, worse.subspan(fresh), length, out);
  if (settings.substeps) {
    print_changes(comparison.between, " between frames", out);
    print_worse(staged, comparison.between.worse, length, out);
  }
  print_gone(comparison, out);
  print_left_out_touches(comparison, out);
}

void print_longest(const scenes::Scene& scene, const CheckReport& report, const ListLength& length,
                   std::ostream& out) {
  scene::label(out, "patches")
      << text::with_commas(report.patches)
      << " in all\n\nlongest patches, lengths of the intersection in the units of the file\n";
  const std::span<const PatchTally::Row> shown = length.shown(report.longest_patches);
  const int width = width_of(shown), width_b = width_of(shown, &PatchTally::Row::b);
  for (const PatchTally::Row& row : shown) {
    out << std::right << std::setw(12) << text::fixed(static_cast<double>(row.length), 6) << "  "
        << std::left << std::setw(width) << row.a << "  " << std::setw(width_b) << row.b << "  "
        << scene::frame_words(scene, row.frame) << " (" << seconds_of(scene, row.frame) << ")\n";
  }
  length.print_rest(report.longest_patches.size(), out);
  out << '\n';
}

void print_inside(const scene::StagedScene& staged, const InsideTally& inside, std::uint32_t stride,
                  const ListLength& length, std::ostream& out) {
  scene::label(out, "inside");
  if (staged.colliders.size() < 2) {
    out << "not tested: --inside compares different instances (or, with --by part, parts), and "
           "there is only one\n";
    return;
  }
  if (inside.closed_colliders == 0) {
    out << "not tested: no surface is closed\n";
    return;
  }
  if (inside.frames_held.empty()) {
    out << "no body is contained in another\n";
  } else {
    out << "a body is contained in another in frames "
        << scene::frame_runs(staged.scene, inside.frames_held, stride) << '\n';
    print_held(staged, "", inside.held, length, out);
  }
  const InsideTally::Deepest& deepest = inside.deepest;
  if (deepest.depth == 0) return;
  scene::label(out, "deepest") << "a vertex of "
                               << scene::collider_name(staged, staged.colliders[deepest.inner])
                               << " is " << text::fixed(deepest.depth, 6) << " deep in "
                               << scene::collider_name(staged, staged.colliders[deepest.outer])
                               << ", " << scene::frame_words(staged.scene, deepest.frame) << '\n';
}

void print_unknown(const CheckSettings& settings, const UnknownTotals& unknown, std::ostream& out) {
  if (!settings.options.budget) return;
  scene::label(out, "unknown");
  if (unknown.frames.empty()) {
    out << "nothing: the budget sufficed for all frames\n";
    return;
  }
  out << text::counted(unknown.frames.size(), "frame") << ": at most "
      << text::counted(unknown.most_pairs, "pair") << " within "
      << text::fixed(unknown.resolution, 3) << '\n';
}

}  // namespace

void ListLength::print_rest(std::size_t count, std::ostream& out) const {
  if (count <= most_) return;
  out << std::right << std::setw(12) << "..."
      << " and " << text::with_commas(count - most_) << " more: --list " << count << '\n';
}

void print_summary(const Stage& stage, const CheckReport& report, const TouchTally& tally,
                   std::ostream& out) {
  const auto& [staged, settings] = std::tie(stage.staged, stage.settings);
  const ListLength length(settings.options.list);
  scene::print_scene(staged, out);
  scene::label(out, "method") << settings.method.name << '\n';
  print_self(settings, staged.colliders.size(), out);
  if (report.verdict.pairs_compared == 0)
    scene::print_too_few(staged.scene, settings.granularity, out);
  if (settings.options.clearance)
    scene::label(out, "clearance")
        << "counts triangles at most " << *settings.options.clearance << " apart\n";
  print_contacts(staged.scene, settings, report, out);
  print_unknown(settings, report.totals.unknown, out);
  if (!report.totals.takes.empty()) print_takes(staged.scene, report.totals.takes, length, out);
  if (report.totals.ignored > 0)
    scene::label(out, "ignored") << text::counted(report.totals.ignored, "contact") << '\n';
  print_left_out(report.totals.left_out, settings.self.rules, out);
  if (report.always) print_always(*report.always, out);
  if (report.totals.between) print_between(staged, *report.totals.between, length, out);
  // Failures come first.
  if (report.verdict.comparison)
    print_comparison(staged, settings, *report.verdict.comparison, length, out);
  print_touching(staged.scene, report, tally, length, out);
  if (report.patches > 0) print_longest(staged.scene, report, length, out);
  if (report.inside) print_inside(staged, *report.inside, settings.frames.stride, length, out);
  scene::print_costs(report.frame_seconds, report.totals.work, out);
  if (report.totals.between) print_costs_between(*report.totals.between, out);
  if (report.totals.hash) scene::label(out, "hash") << text::hex16(*report.totals.hash) << '\n';
  if (report.totals.between)
    scene::label(out, "hash") << text::hex16(report.totals.between->hash)
                              << " of contacts between frames\n";
}

}  // namespace pelt::tools::check
