#include "tools/pelt/check/check.hpp"

#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/summary.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/page/viewer_page.hpp"
#include "tools/pelt/scene/scene_glb.hpp"

#include <array>
#include <sstream>
#include <utility>

namespace pelt::tools::check {
namespace {

/// The outputs of a check. Opened before long work, so that errors appear at once.
struct OutputFiles {
  output::OutputFile jsonl, glb, html;

  Result<void> open(const CheckOptions& options) {
    if (const auto opened = jsonl.open(options.jsonl); !opened) return opened;
    if (const auto opened = glb.open(options.glb); !opened) return opened;
    return html.open(options.html);
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
std::string outer_lines(const CheckAnswer& answer) {
  const CheckReport& report = answer.report;
  const std::vector<Touch> touches = answer.tally.touches();
  std::ostringstream lines;
  JsonlWriter writer(&lines, answer.stage);
  writer.header();
  writer.totals(findings_of(report, touches), report.verdict);
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

/// Passes the answers of all frames to `use`: those of `source`, or, if it is empty, new ones.
Result<void> answer_frames(Stage& stage, const FrameSource& source, bool writes_lines,
                           const UseAnswer& use) {
  const auto answer = [&]() -> Result<void> {
    if (source) return source(stage, use);
    return ask_frames(stage, {0, stage.frames.size()}, writes_lines, use);
  };
  if (!source)
    if (const auto prepared = stage.prepare(); !prepared) return prepared;
  if (const auto answered = answer(); !answered)
    return text::prefixed(stage.staged.scene.name, answered.error());
  return {};
}

/// Removes --threads from a command line, because the answer does not depend on it.
std::string without_threads(std::string words) {
  constexpr std::string_view kOption = " --threads ";
  const std::size_t begin = words.find(kOption);
  if (begin == std::string::npos) return words;
  return words.erase(begin, words.find(' ', begin + kOption.size()) - begin);
}

/// Reports a missing viewer before long work.
Result<void> require_viewer(const CheckOptions& options) {
  if (options.html.empty()) return {};
  if (const auto viewer = page::read_viewer(); !viewer) return viewer.error();
  return {};
}

/// The page counts one clip at a time, so it cannot know the share of all frames.
Result<void> check_filters_for_page(const CheckSettings& settings, const scenes::Scene& scene) {
  if (settings.options.html.empty() || scene.takes.empty() || !settings.self.asks_self() ||
      !settings.self.rules.always)
    return {};
  return text::bad_argument("--html", "cannot be combined with --self-always and all clips ('*')",
                            "leave out --self-always, or name one clip");
}

Result<void> check_outputs(const CheckOptions& options, const scenes::Scene& scene,
                           const EarlierAnswers* earlier) {
  std::vector<output::InputFile> inputs = arguments::files_of_scene(options.scene, scene);
  if (earlier != nullptr)
    for (const std::string& file : earlier->files) inputs.push_back({file, "the shard " + file});
  if (!options.baseline.empty())
    inputs.push_back({options.baseline, "the baseline " + options.baseline});
  for (const std::filesystem::path& place : page::viewer_places())
    inputs.push_back({place, "the viewer's page"});
  const std::array outputs = {output::NamedOutput{"--jsonl", options.jsonl},
                              output::NamedOutput{"--glb", options.glb},
                              output::NamedOutput{"--html", options.html}};
  return output::check_outputs(outputs, inputs);
}

}  // namespace

Result<CheckAnswer> answer_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                 const FrameSource& source, std::ostream* lines) {
  Result<Stage> stage = Stage::make(scene, settings, source ? Frames::answered : Frames::to_query);
  if (!stage) return stage.error();
  Result<TouchTally> tally = TouchTally::make(stage->staged);
  if (!tally) return tally.error();
  JsonlWriter jsonl(lines, *stage);
  jsonl.header();
  CheckRecord record(*stage, *tally, jsonl);
  const auto add = [&](const FrameAnswer& answer) -> Result<void> {
    record.add(answer);
    return {};
  };
  const auto answered = answer_frames(*stage, source, jsonl.is_open(), add);
  if (!answered) return answered.error();
  Result<CheckReport> report = record.finish();
  if (!report) return text::prefixed(scene.name, report.error());
  return CheckAnswer{std::move(*stage), std::move(*tally), std::move(*report)};
}

Result<CheckReport> check_scene(const scenes::Scene& scene, const CheckSettings& settings,
                                std::ostream& words, const FrameSource& source) {
  const CheckOptions& options = settings.options;
  const arguments::ModelArguments& models = options.scene.models;
  OutputFiles files;
  if (const auto opened = files.open(options); !opened) return opened.error();
  Result<CheckAnswer> answer = answer_scene(scene, settings, source, files.jsonl.stream());
  if (!answer) return answer.error();
  const auto& [stage, tally, report] = *answer;
  if (const auto closed = files.jsonl.close(); !closed) return closed.error();
  const auto drawn = write_contacts_glb(files.glb, stage.staged, report.kept, models);
  if (!drawn) return drawn.error();
  if (files.html.stream() != nullptr) {
    const page::PageAnswer of_page = {report.frame_contacts, outer_lines(*answer),
                                      page_steps(report.totals, stage.staged)};
    const auto written =
        write_page(files.html, scene, models, {without_threads(options.words), of_page});
    if (!written) return written.error();
  }
  print_summary(stage, report, tally, words);
  for (const std::string& name : {options.jsonl, options.glb, options.html})
    output::print_written(name, words);
  return std::move(answer->report);
}

Result<arguments::ExitCode> run_check(const CheckOptions& options, const EarlierAnswers* earlier) {
  if (const auto chosen = arguments::choose_simd(options.simd); !chosen) return chosen.error();
  Result<scenes::Scene> scene = arguments::open_scene(options.scene);
  if (!scene) return scene.error();
  if (const auto checked = check_outputs(options, *scene, earlier); !checked)
    return checked.error();
  if (earlier != nullptr) {
    if (const auto same = earlier->check_scene(*scene); !same) return same.error();
  }
  if (const auto found = require_viewer(options); !found) return found.error();
  const Result<CheckSettings> settings = choose_settings(options, *scene);
  if (!settings) return settings.error();
  if (const auto checked = check_filters_for_page(*settings, *scene); !checked)
    return checked.error();
  scene->ignore = settings->ignore;  // for the page, like `self`
  scene->self = without_defaults(settings->self);
  std::ostream& words = output::words_beside({options.jsonl, options.glb, options.html});
  const Result<CheckReport> report =
      check_scene(*scene, *settings, words, earlier != nullptr ? earlier->source : FrameSource());
  if (!report) return report.error();
  if (const auto compared = require_comparison(*report, *settings); !compared)
    return compared.error();
  return report->verdict.is_failed ? arguments::ExitCode::contact : arguments::ExitCode::success;
}

Result<void> require_comparison(const CheckReport& report, const CheckSettings& settings) {
  if (report.verdict.pairs_compared > 0 || settings.options.allow_empty) return {};
  return text::bad_argument(
      "INPUT", "nothing was compared, because a single body was not tested against itself",
      "leave out --self no, --method, --clearance and --between, or give another model, or use "
      "--by part if the model has several parts, or accept this with --allow-empty");
}

}  // namespace pelt::tools::check
