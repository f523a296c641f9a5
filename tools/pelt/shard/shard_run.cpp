#include "tools/pelt/shard/shard_run.hpp"

#include "asset/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/ask_frames.hpp"
#include "tools/pelt/list/list_answer.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/staged_scene.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/shard/shard_file.hpp"

#include <array>
#include <iterator>
#include <span>
#include <utility>

namespace pelt::tools::shard {
namespace {

/// Returns the first given option of the merged answer, or null.
const char* option_of_answer(const check::CheckArguments& arguments) {
  const std::pair<bool, const char*> options[] = {{!arguments.jsonl.empty(), "--jsonl"},
                                                  {!arguments.glb.empty(), "--glb"},
                                                  {arguments.glb_frame.has_value(), "--glb-frame"},
                                                  {!arguments.html.empty(), "--html"},
                                                  {!arguments.baseline.empty(), "--baseline"},
                                                  {!arguments.fail_on.empty(), "--fail-on"},
                                                  {arguments.allow_empty, "--allow-empty"}};
  // A list is judged scene by scene, while the scene is loaded.
  const std::size_t outputs = 4;
  const std::size_t count = arguments.scenes.empty() ? std::size(options) : outputs;
  for (const auto& [is_given, name] : std::span(options).first(count))
    if (is_given) return name;
  return nullptr;
}

Result<void> check_options(const check::CheckArguments& arguments) {
  if (arguments.shard_file.empty())
    return output::bad_argument("--shard", "requires a file to write", "name it with -o FILE");
  if (const char* const option = option_of_answer(arguments))
    return output::bad_argument(option, "cannot be combined with --shard", "give it to pelt merge");
  return {};
}

Result<void> check_output(const check::CheckArguments& arguments, const scenes::Scene& scene) {
  const std::array outputs = {output::NamedOutput{"-o", arguments.shard_file}};
  return output::check_outputs(outputs, arguments::files_of_scene(arguments.scene, scene));
}

/// Queries the frames and adds their answers to the file.
Result<void> write_frames(const check::CheckPlan& plan, const Shard& shard, ShardWriter& writer) {
  const std::size_t frames = plan.frames.size();
  const check::FrameIndices indices = {shard.begin_of(frames), shard.end_of(frames)};
  const auto add = [&](const check::FrameAnswer& answer) -> Result<void> {
    writer.add(answer);
    return {};
  };
  const auto asked = check::ask_frames(plan, indices, plan.settings.threads, add);
  if (!asked) return asset::prefixed(plan.staged.scene.name, asked.error());
  writer.finish();
  return {};
}

void print_shard(const check::CheckPlan& plan, const Shard& shard, std::ostream& words) {
  const std::size_t frames = plan.frames.size();
  const std::size_t begin = shard.begin_of(frames), end = shard.end_of(frames);
  scene::label(words, "shard") << shard.index << " of " << shard.count << ": ";
  if (begin == end) {
    words << "no frames\n";
    return;
  }
  words << scene::frame_runs(plan.staged.scene, std::span(plan.frames).subspan(begin, end - begin),
                             plan.settings.frames.stride)
        << '\n';
}

Result<void> write_shard(const check::CheckArguments& arguments, scenes::Scene& scene,
                         const Shard& shard, output::OutputFile& file, std::ostream& words) {
  const Result<check::CheckSettings> settings = check::choose_settings(arguments, scene);
  if (!settings) return settings.error();
  const auto inputs = inputs_of(arguments.scene, scene);
  if (!inputs) return inputs.error();
  const auto colliders =
      scene::make_colliders(scene, settings->granularity, arguments.scene.models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {scene, *colliders};
  const auto question = check::question_of(*settings, scene, arguments.scene.models);
  const auto plan = check::CheckPlan::make(staged, *settings, question, true);
  if (!plan) return asset::prefixed(scene.name, plan.error());
  ShardWriter writer(*file.stream(), header_json(shard, arguments, *inputs));
  if (const auto written = write_frames(*plan, shard, writer); !written) return written;
  if (const auto closed = file.close(); !closed) return closed;
  scene::print_scene(staged, words);
  print_shard(*plan, shard, words);
  return {};
}

/// Checks the scenes and adds their answers to the file.
Result<void> write_scenes(const list::ListPlan& plan, const list::SceneIndices& indices,
                          ShardWriter& writer, list::ListTally& tally) {
  const auto add = [&](const list::SceneAnswer& answer) -> Result<void> {
    tally.add(answer.entry);
    writer.add(answer);
    return {};
  };
  if (const auto asked = list::ask_scenes(plan, indices, add); !asked) return asked;
  writer.finish();
  return {};
}

void print_shard(const Shard& shard, const list::SceneIndices& indices,
                 const list::ListTally& tally, std::ostream& words) {
  scene::label(words, "shard") << shard.index << " of " << shard.count << ": ";
  if (indices.count() == 0) {
    words << "no scenes\n";
    return;
  }
  words << "scenes " << output::with_commas(indices.begin + 1) << " to "
        << output::with_commas(indices.end) << " of the list, "
        << output::with_commas(tally.unchecked()) << " could not be checked\n";
}

Result<arguments::ExitCode> run_list_shard(const check::CheckArguments& arguments,
                                           const Shard& shard) {
  const Result<list::ListPlan> plan = list::ListPlan::make(arguments);
  if (!plan) return plan.error();
  if (shard.index == 1) list::warn_of_missing_scenes(*plan);  // once for all shards
  const auto inputs = inputs_of(*plan);
  if (!inputs) return inputs.error();
  output::OutputFile file;
  if (const auto opened = file.open(arguments.shard_file); !opened) return opened.error();
  ShardWriter writer(*file.stream(), header_json(shard, arguments, *inputs));
  const std::size_t scenes = plan->scenes.size();
  const list::SceneIndices indices = {shard.begin_of(scenes), shard.end_of(scenes)};
  list::ListTally tally;
  if (const auto written = write_scenes(*plan, indices, writer, tally); !written)
    return written.error();
  if (const auto closed = file.close(); !closed) return closed.error();
  std::ostream& words = output::words_beside({arguments.shard_file});
  print_shard(shard, indices, tally, words);
  output::print_written(arguments.shard_file, words);
  return arguments::ExitCode::success;
}

}  // namespace

Result<arguments::ExitCode> run_shard(const check::CheckArguments& arguments) {
  if (const auto chosen = arguments::choose_simd(arguments.simd); !chosen) return chosen.error();
  const Result<Shard> shard = parse_shard(arguments.shard);
  if (!shard) return shard.error();
  if (const auto checked = check_options(arguments); !checked) return checked.error();
  if (!arguments.scenes.empty()) return run_list_shard(arguments, *shard);
  Result<scenes::Scene> scene = arguments::open_scene(arguments.scene);
  if (!scene) return scene.error();
  if (const auto checked = check_output(arguments, *scene); !checked) return checked.error();
  output::OutputFile file;
  if (const auto opened = file.open(arguments.shard_file); !opened) return opened.error();
  std::ostream& words = output::words_beside({arguments.shard_file});
  const auto written = write_shard(arguments, *scene, *shard, file, words);
  if (!written) return written.error();
  output::print_written(arguments.shard_file, words);
  return arguments::ExitCode::success;
}

}  // namespace pelt::tools::shard
