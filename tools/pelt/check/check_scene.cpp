#include "tools/pelt/check/check_scene.hpp"

#include "asset/message.hpp"
#include "tools/pelt/check/summary.hpp"
#include "tools/pelt/output/line_output.hpp"
#include "tools/pelt/page/viewer_page.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <sstream>

namespace pelt::tools::check {
namespace {

Result<void> write_contacts_glb(const std::string& path, const scene::StagedScene& staged,
                                const CheckReport::Kept& kept,
                                const arguments::ModelArguments& models) {
  const auto posed = scene::pose_instances(staged.scene, kept.frame, models);
  if (!posed) return posed.error();
  return output::write_file(
      path,
      scene::contacts_glb(*posed, scene::touching_triangles(*posed, staged.colliders, kept.found)));
}

/// The first line of --jsonl and the last.
std::string outer_lines(const scene::StagedScene& staged, const CheckQuestion& question,
                        const CheckReport& report, const TouchTally& tally) {
  const std::vector<Touch> touches = tally.touches();
  Findings found = {touches, {}};
  if (report.inside) found.held = report.inside->held;
  std::ostringstream lines;
  JsonlWriter writer(lines, question, staged);
  writer.header();
  writer.totals(report.totals, found, report.verdict);
  return lines.str();
}

Result<void> write_page(const CheckOutputs& outputs, const scenes::Scene& scene,
                        const arguments::ModelArguments& models, const page::PageAnswer& answer) {
  const Result<std::string> page = page::page_of_scene(scene, models, {outputs.words, answer});
  if (!page) return page.error();
  return output::write_file(outputs.html, std::as_bytes(std::span(*page)));
}

}  // namespace

Result<CheckReport> check_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                const arguments::ModelArguments& models,
                                const CheckOutputs& outputs, std::ostream& words) {
  const auto colliders = scene::make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {scene, *colliders};
  Result<TouchTally> tally = TouchTally::make(staged);
  if (!tally) return tally.error();
  output::LineOutput lines;
  if (const auto opened = lines.open(outputs.jsonl); !opened) return opened.error();
  std::optional<JsonlWriter> jsonl;
  const CheckQuestion question = question_of(settings, scene, models);
  if (lines.stream() != nullptr) jsonl.emplace(*lines.stream(), question, staged);
  if (jsonl) jsonl->header();
  JsonlWriter* const writer = jsonl ? &*jsonl : nullptr;
  Result<CheckReport> report = run_check(staged, settings, *tally, writer);
  if (!report) return asset::prefixed(scene.name, report.error());
  if (const auto closed = lines.close(); !closed) return closed.error();
  if (!outputs.glb.empty()) {
    const auto written = write_contacts_glb(outputs.glb, staged, report->kept, models);
    if (!written) return written.error();
  }
  if (!outputs.html.empty()) {
    const page::PageAnswer answer = {report->frame_contacts,
                                     outer_lines(staged, question, *report, *tally)};
    const auto written = write_page(outputs, scene, models, answer);
    if (!written) return written.error();
  }
  print_summary(staged, settings, *report, *tally, words);
  for (const std::string& name : {outputs.jsonl, outputs.glb, outputs.html})
    output::print_written(name, words);
  return report;
}

}  // namespace pelt::tools::check
