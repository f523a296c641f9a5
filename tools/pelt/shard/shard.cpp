#include "tools/pelt/shard/shard.hpp"

#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/frame_query.hpp"
#include "tools/pelt/list/list.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/scene/staged_scene.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/shard/shard_file.hpp"

#include <array>
#include <span>
#include <utility>

namespace pelt::tools::shard {
namespace {

Result<void> check_output(const check::CheckOptions& options, const scenes::Scene& scene) {
  const std::array outputs = {output::NamedOutput{"-o", options.shard_file}};
  return output::check_outputs(outputs, arguments::files_of_scene(options.scene, scene));
}

void print_shard(const check::Stage& stage, const Shard& shard, std::ostream& words) {
  const check::Indices indices = shard.of(stage.frames.size());
  scene::label(words, "shard") << shard.index << " of " << shard.count << ": ";
  if (indices.count() == 0) {
    words << "no frames\n";
    return;
  }
  words << scene::frame_runs(stage.staged.scene,
                             std::span(stage.frames).subspan(indices.begin, indices.count()),
                             stage.settings.frames.stride)
        << '\n';
}

/// Queries the frames of a shard and writes its file.
Result<void> write_shard(const check::CheckOptions& options, scenes::Scene& scene,
                         const Shard& shard, output::OutputFile& file, std::ostream& words) {
  const Result<check::CheckSettings> settings = check::choose_settings(options, scene);
  if (!settings) return settings.error();
  const auto inputs = inputs_of(options.scene, scene);
  if (!inputs) return inputs.error();
  Result<check::Stage> stage = check::Stage::make(scene, *settings);
  if (!stage) return stage.error();
  if (const auto prepared = stage->prepare(); !prepared) return prepared;
  ShardWriter writer(*file.stream(), header_json(shard, options, *inputs));
  const auto add = [&](const check::FrameAnswer& answer) -> Result<void> {
    writer.add(answer);
    return {};
  };
  const auto asked = check::ask_frames(*stage, shard.of(stage->frames.size()), true, add);
  if (!asked) return text::prefixed(scene.name, asked.error());
  writer.finish();
  if (const auto closed = file.close(); !closed) return closed;
  scene::print_scene(stage->staged, words);
  print_shard(*stage, shard, words);
  return {};
}

void print_shard(const Shard& shard, const check::Indices& indices, const list::ListTally& tally,
                 std::ostream& words) {
  scene::label(words, "shard") << shard.index << " of " << shard.count << ": ";
  if (indices.count() == 0) {
    words << "no scenes\n";
    return;
  }
  words << "scenes " << text::with_commas(indices.begin + 1) << " to "
        << text::with_commas(indices.end) << " of the list, "
        << text::with_commas(tally.unchecked()) << " could not be checked\n";
}

Result<arguments::ExitCode> run_list_shard(const check::CheckOptions& options, const Shard& shard) {
  const Result<list::ListPlan> plan = list::ListPlan::make(options);
  if (!plan) return plan.error();
  if (shard.index == 1) list::warn_of_missing_scenes(*plan);  // once for all shards
  const auto inputs = inputs_of(*plan);
  if (!inputs) return inputs.error();
  output::OutputFile file;
  if (const auto opened = file.open(options.shard_file); !opened) return opened.error();
  ShardWriter writer(*file.stream(), header_json(shard, options, *inputs));
  const check::Indices indices = shard.of(plan->scenes.size());
  list::ListTally tally;
  const auto add = [&](const list::SceneAnswer& answer) -> Result<void> {
    tally.add(answer.entry);
    writer.add(answer);
    return {};
  };
  if (const auto asked = list::ask_scenes(*plan, indices, add); !asked) return asked.error();
  writer.finish();
  if (const auto closed = file.close(); !closed) return closed.error();
  std::ostream& words = output::words_beside({options.shard_file});
  print_shard(shard, indices, tally, words);
  output::print_written(options.shard_file, words);
  return arguments::ExitCode::success;
}

}  // namespace

Result<arguments::ExitCode> run_shard(const check::CheckOptions& options) {
  if (const auto chosen = arguments::choose_simd(options.simd); !chosen) return chosen.error();
  const Result<Shard> shard = parse_shard(options.shard);
  if (!shard) return shard.error();
  if (options.shard_file.empty())
    return text::bad_argument("--shard", "requires a file to write", "name it with -o FILE");
  if (!options.scenes.empty()) return run_list_shard(options, *shard);
  Result<scenes::Scene> scene = arguments::open_scene(options.scene);
  if (!scene) return scene.error();
  if (const auto checked = check_output(options, *scene); !checked) return checked.error();
  output::OutputFile file;
  if (const auto opened = file.open(options.shard_file); !opened) return opened.error();
  std::ostream& words = output::words_beside({options.shard_file});
  const auto written = write_shard(options, *scene, *shard, file, words);
  if (!written) return written.error();
  output::print_written(options.shard_file, words);
  return arguments::ExitCode::success;
}

}  // namespace pelt::tools::shard
