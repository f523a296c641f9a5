/// `pelt merge`: the answer of a check whose frames or scenes were queried in shards.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/check_command.hpp"
#include "tools/pelt/list/list_answer.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/shard/shard_file.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <array>
#include <memory>
#include <utility>

namespace pelt::tools::verbs {
namespace {

constexpr const char* kFooter = R"(
Examples:
  pelt check scene.json --shard 1/2 -o 1.shard
  pelt check scene.json --shard 2/2 -o 2.shard
  pelt merge 1.shard 2.shard --jsonl contacts.jsonl
  pelt merge 2.shard 1.shard --fail-on never

The answer is that of one `pelt check` with the options of the shards: the same summary, the same
lines of --jsonl, the same hash and the same exit code. Only measured times differ. Files are given in
any order. Each shard must be given once, complete, and from the same check of the same inputs by the
same version of pelt. `pelt merge` reads the scene and its models again, so run it in the folder of the
checks. The shards of a list (check --scenes) contain all that is needed, with the verdicts; a list has
no --html and no --glb.)";

struct Arguments {
  std::vector<std::string> files;
  check::CheckArguments outcome;  ///< only the options of the verdict, the outputs and --threads
};

/// The arguments of the shards, with those of the outcome.
check::CheckArguments with_outcome(check::CheckArguments of_shards,
                                   const check::CheckArguments& outcome) {
  of_shards.baseline = outcome.baseline;
  of_shards.fail_on = outcome.fail_on;
  of_shards.allow_empty = outcome.allow_empty;
  of_shards.list = outcome.list;
  of_shards.jsonl = outcome.jsonl;
  of_shards.html = outcome.html;
  of_shards.glb = outcome.glb;
  of_shards.glb_frame = outcome.glb_frame;
  of_shards.words = outcome.words;
  of_shards.threads = outcome.threads;
  return of_shards;
}

/// Returns the first given option that a list does not have when its shards are merged, with what
/// to do instead, or null.
std::pair<const char*, const char*> option_of_one_scene(const check::CheckArguments& outcome) {
  constexpr const char* kOfShards = "give it to each pelt check --shard";
  constexpr const char* kAlone = "check that scene alone";
  if (!outcome.baseline.empty()) return {"--baseline", kOfShards};
  if (!outcome.fail_on.empty()) return {"--fail-on", kOfShards};
  if (outcome.allow_empty) return {"--allow-empty", kOfShards};
  if (!outcome.html.empty()) return {"--html", kAlone};
  if (!outcome.glb.empty()) return {"--glb", kAlone};
  return {outcome.glb_frame ? "--glb-frame" : nullptr, kAlone};
}

/// Merges the shards of a list of scenes.
Result<arguments::ExitCode> merge_list(const shard::Shards& shards, const Arguments& arguments) {
  const auto [option, remedy] = option_of_one_scene(arguments.outcome);
  if (option != nullptr)
    return output::bad_argument(option, "cannot be combined with shards of a list of scenes",
                                remedy);
  std::vector<output::InputFile> inputs;
  for (const std::string& file : arguments.files) inputs.push_back({file, "the shard " + file});
  const std::array outputs = {output::NamedOutput{"--jsonl", arguments.outcome.jsonl}};
  if (const auto checked = output::check_outputs(outputs, inputs); !checked) return checked.error();
  return list::write_list(arguments.outcome, shards.scenes(),
                          [&](const list::UseScene& use) { return shards.replay_scenes(use); });
}

Result<arguments::ExitCode> merge(const Arguments& arguments, methods::MethodKinds known_methods) {
  const Result<shard::Shards> shards =
      shard::Shards::open(arguments.files, arguments.outcome.threads.value_or(0));
  if (!shards) return shards.error();
  if (shards->is_of_list()) return merge_list(*shards, arguments);
  check::CheckArguments of_check = with_outcome(shards->arguments(), arguments.outcome);
  of_check.known_methods = known_methods;
  const auto replay = [&](const scene::StagedScene& staged, const check::CheckSettings& settings,
                          const check::UseAnswer& use) {
    return shards->replay(staged, settings, use);
  };
  const auto check_scene = [&](const scenes::Scene& scene) { return shards->check_inputs(scene); };
  const check::EarlierAnswers earlier = {replay, arguments.files, check_scene};
  return check::run_check_command(of_check, &earlier);
}

}  // namespace

void add_merge(CLI::App& app, arguments::Command& chosen, methods::MethodKinds known_methods) {
  arguments::Verb verb(app, "merge", "Put the shards of a check together", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  verb.option("FILES", arguments->files, "Files that pelt check --shard wrote, in any order",
              {.type = "FILE", .is_required = true});
  check::add_verdict_options(verb, arguments->outcome);
  check::add_picture_options(verb, arguments->outcome);
  verb.option("--threads", arguments->outcome.threads,
              "Read the answers on N threads (default: one per core)",
              {.type = "N", .least = 1, .most = 1024});
  verb.tells(arguments->outcome.words);
  verb.runs([arguments, known_methods] { return merge(*arguments, known_methods); }, chosen);
}

}  // namespace pelt::tools::verbs
