/// `pelt check`: which triangles collide, frame by frame.

#include "tools/pelt/check/check.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/list/list.hpp"
#include "tools/pelt/shard/shard.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <memory>

namespace pelt::tools::verbs {
namespace {

constexpr const char* kFooter = R"(
Examples:
  pelt check scene.json
  pelt check knight.glb barbarian.glb --clip Walk --clip Attack --at 0,0,-0.5 --at 0,0,0.5 --turn 0 --turn 180
  pelt check knight.glb --clip Walk
  pelt check knight.glb --clip Walk --by part
  pelt check knight.glb --clip '*' --by part --jsonl clips.jsonl
  pelt check scene.json --frames 20:40 --jsonl contacts.jsonl --pairs
  pelt check scene.json --contacts --jsonl contacts.jsonl
  pelt check scene.json --clearance 0.02
  pelt check scene.json --budget 20000 --fail-on unknown
  pelt check scene.json --inside
  pelt check scene.json --between --substeps 4 --fail-on between
  pelt check scene.json --self --self-rings 2 --self-near-joints drop
  pelt check scene.json --first --jsonl - > contacts.jsonl
  pelt check scene.json --glb worst.glb
  pelt check scene.json --html report.html
  pelt check scene.json --method brute --frames 24:25
  pelt check scene.json --ignore limb,joint*
  pelt check scene.json --baseline contacts.jsonl
  pelt check scene.json --shard 1/2 -o 1.shard
  pelt check --scenes scenes.txt --jsonl answers.jsonl
  pelt check --scenes scenes.txt --shard 1/2 -o 1.shard

Answers are exact on the float32 positions that `pelt pose` writes. Triangles are closed sets, so
touching counts. All methods give the same contacts and the same hash; they differ in their work.
With --by part, a and b are indices of the header's "instances", which has one entry per part.
--ignore takes two names of parts or joints. A name like knight/hand_r applies to one model only, and
* matches any characters. With --baseline, the --jsonl output of an earlier check, only contacts that
are new or have grown fail the check.
With --budget, contacts may be missing. The line "unknown" of the summary shows in how many frames, how
many pairs of triangles are undecided at most, and how long the regions are in which they are.
--fail-on unknown fails on contacts and on undecided pairs. The answer is the same on every machine.
With --between, a step leads from each checked frame to the next. In a step, or in each of its
--substeps, every vertex moves in a straight line at constant speed, and the answer is exact for this
motion. The summary shows how far the clips deviate from it. A contact between frames is a contact for
the exit code and for --baseline.
With --scenes, each line of the file names a scene or a model, relative to the current folder. Each is
checked alone, several at a time. A scene that cannot be checked is named, the others are checked, and
the exit code is 2. The answer of --jsonl has a line for each scene, followed by the lines of its check;
--baseline is such an answer.
With --shard, `pelt merge` puts the files of all shards together, judges them and writes the other
outputs. Shards of a list are judged already, so --baseline and --fail-on belong to each of them. The exit
code of a shard is 0 if its file is complete, whatever it contains.
A single character is tested against itself; several characters only with --self. The options
--self-... drop contacts of a character with itself; the summary shows how many each option drops. A
check that has nothing to test, such as one of a single character with --self no, fails with exit code
2, unless --allow-empty is given.
Exit codes: 0 nothing that --fail-on selects, 1 what --fail-on selects (by default any contact, with
--between also any contact between frames, and with --inside any contained body; with --baseline only
what is new or has grown), 2 bad input or arguments, or nothing to test, 3 internal error.)";

Result<arguments::ExitCode> check(const check::CheckOptions& options) {
  if (options.scene.inputs.empty() && options.scenes.empty())
    return text::bad_argument("INPUT", "is required",
                              "give a scene or models, or a list with --scenes FILE; see pelt "
                              "check --help");
  if (!options.scene.inputs.empty() && !options.scenes.empty())
    return text::bad_argument("--scenes", "cannot be combined with INPUT",
                              "add " + options.scene.inputs[0] + " to the list");
  if (const auto checked = check::check_options(options); !checked) return checked.error();
  if (!options.shard.empty()) return shard::run_shard(options);
  if (!options.shard_file.empty())
    return text::bad_argument("-o", "requires --shard", "name the answer with --jsonl FILE");
  if (!options.scenes.empty()) return list::run_list(options);
  return check::run_check(options);
}

}  // namespace

void add_check(CLI::App& app, arguments::Command& chosen, methods::MethodKinds known_methods) {
  arguments::Verb verb(app, "check", "Find every pair of intersecting triangles in every frame",
                       kFooter);
  const auto options = std::make_shared<check::CheckOptions>();
  options->known_methods = known_methods;
  check::add_check_options(verb, *options);
  verb.tells(options->words);
  verb.runs([options] { return check(*options); }, chosen);
}

}  // namespace pelt::tools::verbs
