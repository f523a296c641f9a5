/// `pelt merge`: the answer of a check whose frames or scenes were queried in shards.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/check.hpp"
#include "tools/pelt/list/list.hpp"
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
  check::CheckOptions outcome;  ///< only the options of the verdict, the outputs and --threads
};

/// Merges the shards of a list of scenes.
Result<arguments::ExitCode> merge_list(const shard::Shards& shards, const Arguments& arguments) {
  const check::CheckOptions& outcome = arguments.outcome;
  if (const auto checked = check::check_conflicts(outcome, check::kShardsOfList); !checked)
    return checked.error();
  std::vector<output::InputFile> inputs;
  for (const std::string& file : arguments.files) inputs.push_back({file, "the shard " + file});
  const std::array outputs = {output::NamedOutput{"--jsonl", outcome.jsonl}};
  if (const auto checked = output::check_outputs(outputs, inputs); !checked) return checked.error();
  return list::write_list(outcome, shards.scenes(),
                          [&](const list::UseScene& use) { return shards.replay_scenes(use); });
}

Result<arguments::ExitCode> merge(const Arguments& arguments, methods::MethodKinds known_methods) {
  const Result<shard::Shards> shards =
      shard::Shards::open(arguments.files, arguments.outcome.threads.value_or(0));
  if (!shards) return shards.error();
  if (shards->is_of_list()) return merge_list(*shards, arguments);
  check::CheckOptions options = shards->options();
  check::copy_outcome(arguments.outcome, options);
  options.known_methods = known_methods;
  if (const auto checked = check::check_options(options); !checked) return checked.error();
  const auto replay = [&](const check::Stage& stage, const check::UseAnswer& use) {
    return shards->replay(stage, use);
  };
  const auto check_scene = [&](const scenes::Scene& scene) { return shards->check_inputs(scene); };
  const check::EarlierAnswers earlier = {replay, arguments.files, check_scene};
  return check::run_check(options, &earlier);
}

}  // namespace

void add_merge(CLI::App& app, arguments::Command& chosen, methods::MethodKinds known_methods) {
  arguments::Verb verb(app, "merge", "Put the shards of a check together", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  verb.option("FILES", arguments->files, "Files that pelt check --shard wrote, in any order",
              {.type = "FILE", .is_required = true});
  check::add_outcome_options(verb, arguments->outcome);
  verb.option("--threads", arguments->outcome.threads,
              "Read the answers on N threads (default: one per core)",
              {.type = "N", .least = 1, .most = 1024});
  verb.tells(arguments->outcome.words);
  verb.runs([arguments, known_methods] { return merge(*arguments, known_methods); }, chosen);
}

}  // namespace pelt::tools::verbs
