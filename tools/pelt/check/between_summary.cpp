#include "tools/pelt/check/between_summary.hpp"

#include "tools/pelt/check/feature_name.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <algorithm>
#include <iomanip>

namespace pelt::tools::check {
namespace {

constexpr const char* kRepeated = "";  // label of the lines of a list

std::string seconds_words(double seconds) { return output::fixed(seconds, 4) + " s"; }

/// "edge 1 of triangle 12 of knight 0"
std::string feature_words(const scene::StagedScene& staged, std::uint32_t collider,
                          std::uint32_t triangle, const Feature& feature) {
  std::string text = name_of(feature.kind);
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
    out << std::right << std::setw(12) << output::with_commas(step.contacts) << "  from "
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
  out << "vertices deviate at most " << output::fixed(report.deviation.distance, 6)
      << " from straight lines (middle of a piece, from "
      << scene::frame_words(staged.scene, report.deviation.from) << ", "
      << scene::collider_name(staged, staged.colliders[report.deviation.collider]) << ")\n";
  scene::label(out, kRepeated) << "in this step";
  const char* separator = ": ";
  for (const BetweenReport::Fall& fall : report.falls) {
    out << separator << output::fixed(fall.distance, 6) << " with --substeps " << fall.substeps;
    separator = ", ";
  }
  out << '\n';
}

}  // namespace

void print_between(const scene::StagedScene& staged, const BetweenReport& report,
                   const ListLength& length, std::ostream& out) {
  scene::label(out, "between");
  if (report.steps == 0) {
    out << "not tested: --between needs two frames of one clip, and there is only one frame\n";
    return;
  }
  if (report.contacts == 0) {
    out << "no pair touches between frames only, in " << output::counted(report.steps, "step")
        << '\n';
  } else {
    out << output::counted(report.contacts, "pair")
        << (report.contacts == 1 ? " touches in " : " touch in ")
        << output::counted(report.found.size(), "step") << " at neither end; first at "
        << seconds_words(report.found.front().earliest.first.seconds)
        << scene::clip_words(staged.scene, report.found.front().from) << '\n';
    print_steps(staged, report, length, out);
  }
  print_deviation(staged, report, out);
}

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
                             << output::fixed(1e3 * output::median(report.step_seconds), 3)
                             << " ms, mean "
                             << output::fixed(1e3 * output::mean(report.step_seconds), 3)
                             << " ms per step\n";
}

}  // namespace pelt::tools::check
