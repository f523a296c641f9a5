/// `pelt bounds`: how large posed characters are, frame by frame.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/line_output.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/bounds_scene.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include "asset/message.hpp"

namespace pelt::tools {
namespace {

struct Arguments {
  QueryArguments query;
  std::string by = "instance";
  bool exact = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt bounds scene.json
  pelt bounds scene.json --frames 20:21 --exact --by part
  pelt bounds knight.glb --clip Walk --by joint --jsonl -
  pelt bounds knight.glb --clip Attack --exact --jsonl bounds.jsonl

Boxes and spheres are guaranteed to enclose every triangle. Without --exact they are computed from
the joint matrices alone, without skinning; a box is then a few per cent to 25 % larger than the
exact one. With --by joint, a box encloses the vertices for which the joint has the largest weight.)";

Result<BoundsBy> choose_by(const std::string& name) {
  if (name == "instance") return BoundsBy::instance;
  if (name == "part") return BoundsBy::part;
  if (name == "joint") return BoundsBy::joint;
  return bad_argument("--by", "there is no " + asset::quoted(name), "give instance, part or joint");
}

Result<ExitCode> bounds(const Arguments& arguments) {
  const Result<BoundsBy> by = choose_by(arguments.by);
  if (!by) return by.error();
  const Result<QueryInput> input = open_query(arguments.query);
  if (!input) return input.error();
  const BoundsSettings settings = {
      *by, arguments.exact ? BoundsKind::exact : BoundsKind::guaranteed, input->frames};
  const Result<void> answered =
      bounds_scene(input->scene, settings, arguments.query.scene.models, arguments.query.jsonl,
                   words_beside(arguments.query.jsonl));
  if (!answered) return answered.error();
  return ExitCode::success;
}

}  // namespace

void add_bounds(CLI::App& app, Command& chosen) {
  Verb verb(app, "bounds", "Compute boxes and spheres around the characters in every frame",
            kFooter);
  const auto arguments = std::make_shared<Arguments>();
  add_query_options(verb, arguments->query);
  verb.flag(
      "--exact", arguments->exact,
      "Compute the smallest box around the posed vertices that triangles use, exact to the bit");
  verb.option("--by", arguments->by, "What gets bounds: each instance, each part, or each joint",
              {.type = "instance|part|joint"});
  verb.runs([arguments] { return bounds(*arguments); }, chosen);
}

}  // namespace pelt::tools
