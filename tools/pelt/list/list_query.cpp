#include "tools/pelt/list/list_query.hpp"

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "base/workers.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/check/check_command.hpp"
#include "tools/pelt/check/check_scene.hpp"
#include "tools/pelt/check/ordered_work.hpp"
#include "tools/pelt/list/scene_list.hpp"
#include "tools/pelt/output/progress.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

namespace pelt::tools::list {
namespace {

/// Returns the first given option of files that one scene has, or null.
const char* option_of_one_scene(const check::CheckArguments& arguments) {
  if (!arguments.html.empty()) return "--html";
  if (!arguments.glb.empty()) return "--glb";
  return arguments.glb_frame ? "--glb-frame" : nullptr;
}

Result<void> check_options(const check::CheckArguments& arguments) {
  if (!arguments.scene.inputs.empty())
    return output::bad_argument("--scenes", "cannot be combined with INPUT",
                                "add " + arguments.scene.inputs[0] + " to the list");
  if (const char* const option = option_of_one_scene(arguments))
    return output::bad_argument(option, "cannot be combined with --scenes",
                                "check that scene alone");
  return {};
}

/// Checks an opened scene and writes its lines.
Result<check::CheckReport> check_opened(const check::CheckArguments& arguments,
                                        scenes::Scene& scene, std::ostream& lines) {
  const Result<check::CheckSettings> settings = check::choose_settings(arguments, scene);
  if (!settings) return settings.error();
  const arguments::ModelArguments& models = arguments.scene.models;
  const auto colliders = scene::make_colliders(scene, settings->granularity, models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {scene, *colliders};
  Result<check::TouchTally> tally = check::TouchTally::make(staged);
  if (!tally) return tally.error();
  const check::CheckQuestion question = check::question_of(*settings, scene, models);
  auto report = check::answer_scene(staged, *settings, question, nullptr, *tally, &lines);
  if (report && report->verdict.pairs_compared == 0 && !arguments.allow_empty)
    return check::nothing_compared();
  return report;
}

/// Returns an error only if an output would replace a file of the scene.
Result<void> ask_scene(const ListPlan& plan, const std::string& name, std::uint32_t threads,
                       SceneAnswer& answer) {
  check::CheckArguments arguments = plan.arguments;
  arguments.scene.inputs = {name};
  arguments.threads = threads;
  if (plan.baseline) arguments.baseline_text = plan.baseline->text_of(name);
  Result<scenes::Scene> scene = arguments::open_scene(arguments.scene);
  if (!scene) {
    answer = unchecked(name, scene.error());
    return {};
  }
  const auto inputs = arguments::files_of_scene(arguments.scene, *scene);
  if (const auto checked = output::check_outputs(plan.outputs, inputs); !checked) return checked;
  std::ostringstream lines;
  const auto report = check_opened(arguments, *scene, lines);
  answer = report ? answer_of(name, *report, lines.str()) : unchecked(name, report.error());
  return {};
}

}  // namespace

Result<ListPlan> ListPlan::make(const check::CheckArguments& arguments) {
  if (const auto checked = check_options(arguments); !checked) return checked.error();
  ListPlan plan;
  plan.arguments = arguments;
  plan.outputs = {{"--jsonl", arguments.jsonl}, {"-o", arguments.shard_file}};
  auto scenes = read_scene_list(arguments.scenes);
  if (!scenes) return scenes.error();
  plan.scenes = std::move(*scenes);
  std::vector<output::InputFile> inputs = {
      {arguments.scenes, "the list of scenes " + arguments.scenes}};
  if (!arguments.baseline.empty())
    inputs.push_back({arguments.baseline, "the baseline " + arguments.baseline});
  for (const std::string& scene : plan.scenes) inputs.push_back({scene, "the scene " + scene});
  if (const auto checked = output::check_outputs(plan.outputs, inputs); !checked)
    return checked.error();
  if (arguments.baseline.empty()) return plan;
  auto baseline = ListBaseline::read(arguments.baseline);
  if (!baseline) return baseline.error();
  plan.baseline = std::move(*baseline);
  return plan;
}

void warn_of_missing_scenes(const ListPlan& plan) {
  if (!plan.baseline) return;
  const std::vector<std::string> missing = plan.baseline->scenes_missing_in(plan.scenes);
  if (missing.empty()) return;
  std::cerr << "pelt: warning: --baseline: " << asset::printable(plan.arguments.baseline)
            << ": has " << output::counted(missing.size(), "scene") << " that "
            << asset::printable(plan.arguments.scenes) << " lacks, first "
            << asset::quoted(missing[0])
            << ": add scenes that were lost or renamed, or write a new baseline\n";
}

Result<void> ask_scenes(const ListPlan& plan, const SceneIndices& indices, const UseScene& use) {
  const std::uint32_t threads =
      detail::Workers::count_or_available(plan.arguments.threads.value_or(0));
  const auto workers =
      static_cast<std::uint32_t>(std::clamp<std::size_t>(indices.count(), 1, threads));
  output::Progress progress(indices.count());
  const auto ask = [&](std::uint32_t, std::size_t index, SceneAnswer& answer) {
    return ask_scene(plan, plan.scenes[indices.begin + index], threads / workers, answer);
  };
  const auto pass_on = [&](const SceneAnswer& answer) {
    progress.advance();
    return use(answer);
  };
  return check::OrderedWork<SceneAnswer>(indices.count(), workers, ask, pass_on).run();
}

}  // namespace pelt::tools::list
