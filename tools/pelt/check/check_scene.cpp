#include "tools/pelt/check/check_scene.hpp"

#include "asset/message.hpp"
#include "tools/pelt/check/summary.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/page/viewer_page.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <sstream>

namespace pelt::tools::check {
namespace {

/// The outputs of a check. Opened before long work, so that errors appear at once.
struct OutputFiles {
  output::OutputFile jsonl, glb, html;

  Result<void> open(const CheckOutputs& outputs) {
    if (const auto opened = jsonl.open(outputs.jsonl); !opened) return opened;
    if (const auto opened = glb.open(outputs.glb); !opened) return opened;
    return html.open(outputs.html);
  }
};

Result<void> write_contacts_glb(output::OutputFile& file, const scene::StagedScene& staged,
                                const CheckReport::Kept& kept,
                                const arguments::ModelArguments& models) {
  if (file.stream() == nullptr) return {};
  const auto posed = scene::pose_instances(staged.scene, kept.frame, models);
  if (!posed) return posed.error();
  return file.write_and_close(
      scene::contacts_glb(*posed, scene::touching_triangles(*posed, staged.colliders, kept.found)));
}

/// The first and the last line of --jsonl.
std::string outer_lines(const scene::StagedScene& staged, const CheckQuestion& question,
                        const CheckReport& report, const TouchTally& tally) {
  const std::vector<Touch> touches = tally.touches();
  Findings found = {touches};
  if (report.inside) found.held = report.inside->held;
  if (report.totals.between) found.between = report.totals.between->touches;
  std::ostringstream lines;
  JsonlWriter writer(&lines, question, staged);
  writer.header();
  writer.totals(report.totals, found, report.verdict);
  return lines.str();
}

/// Returns nullopt without --between.
std::optional<std::vector<page::PageStep>> page_steps(const CheckTotals& totals,
                                                      const scene::StagedScene& staged) {
  if (!totals.between) return std::nullopt;
  std::vector<page::PageStep> steps;
  for (const StepBetween& step : totals.between->found) {
    const auto& [a, b, contact, first] = step.earliest;
    steps.push_back({.from = step.from,
                     .to = step.to,
                     .contacts = step.contacts,
                     .first_seconds = first.seconds,
                     .first_share = first.share,
                     .a = staged.colliders[a].instance,
                     .b = staged.colliders[b].instance,
                     .triangles = contact,
                     .is_of_self = a == b});
  }
  return steps;
}

Result<void> write_page(output::OutputFile& file, const scenes::Scene& scene,
                        const arguments::ModelArguments& models, const page::PageData& data) {
  const Result<std::string> page = page::page_of_scene(scene, models, data);
  if (!page) return page.error();
  return file.write_and_close(std::as_bytes(std::span(*page)));
}

/// Colliders that are not queried, because there are answers. Fitting their trees to sample poses
/// would take most of the time to make them.
Result<std::vector<scene::Collider>> make_colliders_to_name(
    const scenes::Scene& scene, scene::Granularity granularity,
    const arguments::ModelArguments& models) {
  arguments::ModelArguments without_samples = models;
  without_samples.samples = 0;
  return scene::make_colliders(scene, granularity, without_samples);
}

}  // namespace

Result<CheckReport> answer_scene(const scene::StagedScene& staged, const CheckSettings& settings,
                                 const CheckQuestion& question, const FrameSource& source,
                                 TouchTally& tally, std::ostream* lines) {
  JsonlWriter jsonl(lines, question, staged);
  jsonl.header();
  Result<CheckReport> report = run_check(staged, settings, question, source, tally, jsonl);
  if (!report) return asset::prefixed(staged.scene.name, report.error());
  return report;
}

Result<CheckReport> check_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                const arguments::ModelArguments& models,
                                const CheckOutputs& outputs, std::ostream& words,
                                const FrameSource& source) {
  OutputFiles files;
  if (const auto opened = files.open(outputs); !opened) return opened.error();
  const auto colliders = source ? make_colliders_to_name(scene, settings.granularity, models)
                                : scene::make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {scene, *colliders};
  Result<TouchTally> tally = TouchTally::make(staged);
  if (!tally) return tally.error();
  const CheckQuestion question = question_of(settings, scene, models);
  Result<CheckReport> report =
      answer_scene(staged, settings, question, source, *tally, files.jsonl.stream());
  if (!report) return report;
  if (const auto closed = files.jsonl.close(); !closed) return closed.error();
  const auto drawn = write_contacts_glb(files.glb, staged, report->kept, models);
  if (!drawn) return drawn.error();
  if (files.html.stream() != nullptr) {
    const page::PageAnswer answer = {report->frame_contacts,
                                     outer_lines(staged, question, *report, *tally),
                                     page_steps(report->totals, staged)};
    const auto written = write_page(files.html, scene, models, {outputs.words, answer});
    if (!written) return written.error();
  }
  print_summary(staged, settings, *report, *tally, words);
  for (const std::string& name : {outputs.jsonl, outputs.glb, outputs.html})
    output::print_written(name, words);
  return report;
}

}  // namespace pelt::tools::check
