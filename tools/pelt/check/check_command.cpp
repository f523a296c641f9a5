#include "tools/pelt/check/check_command.hpp"

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/check_scene.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/page/viewer_page.hpp"

#include <array>

namespace pelt::tools::check {
namespace {

Result<void> check_for_page(const CheckArguments& arguments) {
  if (arguments.html.empty()) return {};
  // Report missing inputs before long work.
  if (const auto viewer = page::read_viewer(); !viewer) return viewer.error();
  return {};
}

/// Removes --threads from a command line, because the answer does not depend on it.
std::string without_threads(std::string words) {
  constexpr std::string_view kOption = " --threads ";
  const std::size_t begin = words.find(kOption);
  if (begin == std::string::npos) return words;
  return words.erase(begin, words.find(' ', begin + kOption.size()) - begin);
}

/// The page counts one clip at a time, so it cannot know the share of all frames.
Result<void> check_filters_for_page(const CheckArguments& arguments, const CheckSettings& settings,
                                    const scenes::Scene& scene) {
  if (arguments.html.empty() || scene.takes.empty() || !settings.self.asks_self() ||
      !settings.self.rules.always)
    return {};
  return output::bad_argument("--html", "cannot be combined with --self-always and all clips ('*')",
                              "leave out --self-always, or name one clip");
}

Result<void> check_outputs(const CheckArguments& arguments, const scenes::Scene& scene,
                           const EarlierAnswers* earlier) {
  std::vector<output::InputFile> inputs = arguments::files_of_scene(arguments.scene, scene);
  if (earlier != nullptr)
    for (const std::string& file : earlier->files) inputs.push_back({file, "the shard " + file});
  if (!arguments.baseline.empty())
    inputs.push_back({arguments.baseline, "the baseline " + arguments.baseline});
  for (const std::filesystem::path& place : page::viewer_places())
    inputs.push_back({place, "the viewer's page"});
  const std::array outputs = {output::NamedOutput{"--jsonl", arguments.jsonl},
                              output::NamedOutput{"--glb", arguments.glb},
                              output::NamedOutput{"--html", arguments.html}};
  return output::check_outputs(outputs, inputs);
}

}  // namespace

Result<arguments::ExitCode> run_check_command(const CheckArguments& arguments,
                                              const EarlierAnswers* earlier) {
  if (const auto chosen = arguments::choose_simd(arguments.simd); !chosen) return chosen.error();
  Result<scenes::Scene> scene = arguments::open_scene(arguments.scene);
  if (!scene) return scene.error();
  if (const auto checked = check_outputs(arguments, *scene, earlier); !checked)
    return checked.error();
  if (earlier != nullptr) {
    if (const auto same = earlier->check_scene(*scene); !same) return same.error();
  }
  if (const auto checked = check_for_page(arguments); !checked) return checked.error();
  const Result<CheckSettings> settings = choose_settings(arguments, *scene);
  if (!settings) return settings.error();
  if (const auto checked = check_filters_for_page(arguments, *settings, *scene); !checked)
    return checked.error();
  scene->ignore = settings->ignore;  // for the page, like `self`
  scene->self = without_defaults(settings->self);
  CheckOutputs outputs;
  outputs.jsonl = arguments.jsonl;
  outputs.glb = arguments.glb;
  outputs.html = arguments.html;
  outputs.words = without_threads(arguments.words);
  const Result<CheckReport> report =
      check_scene(*scene, *settings, arguments.scene.models, outputs,
                  output::words_beside({arguments.jsonl, arguments.glb, arguments.html}),
                  earlier != nullptr ? earlier->source : FrameSource());
  if (!report) return report.error();
  if (report->verdict.pairs_compared == 0 && !arguments.allow_empty) return nothing_compared();
  return report->verdict.is_failed ? arguments::ExitCode::contact : arguments::ExitCode::success;
}

Error nothing_compared() {
  return output::bad_argument(
      "INPUT", "nothing was compared, because a single body was not tested against itself",
      "leave out --self no, --method, --clearance and --between, or give another model, or use "
      "--by part if "
      "the model has several parts, or accept this with --allow-empty");
}

}  // namespace pelt::tools::check
