/// `pelt bounds`: the size of posed characters, frame by frame.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/bounds_query.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include "asset/message.hpp"

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  scene::QueryArguments query;
  std::string by = "instance";
  bool exact = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt bounds scene.json
  pelt bounds scene.json --frames 20:21 --exact --by part
  pelt bounds knight.glb --clip Walk --by joint --jsonl -
  pelt bounds knight.glb --clip Attack --exact --jsonl bounds.jsonl

Boxes and spheres are guaranteed to enclose every triangle. Without --exact, they are computed from
the joint matrices and the morph weights, without skinning. For a human in motion, a box is then a
few per cent to 25 % larger than the exact box. With --by joint, a box encloses the vertices for which
the joint has the largest weight.)";

Result<query::BoundsBy> choose_by(const std::string& name) {
  if (name == "instance") return query::BoundsBy::instance;
  if (name == "part") return query::BoundsBy::part;
  if (name == "joint") return query::BoundsBy::joint;
  return output::bad_argument("--by", "unknown value " + asset::quoted(name),
                              "give instance, part or joint");
}

Result<arguments::ExitCode> bounds(const Arguments& arguments) {
  const Result<query::BoundsBy> by = choose_by(arguments.by);
  if (!by) return by.error();
  const Result<scene::QueryInput> input = scene::open_query(arguments.query);
  if (!input) return input.error();
  const auto granularity =
      *by == query::BoundsBy::part ? scene::Granularity::part : scene::Granularity::instance;
  const auto colliders =
      scene::make_colliders(input->scene, granularity, arguments.query.scene.models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {input->scene, *colliders};
  query::BoundsQuery query(
      staged, {*by, arguments.exact ? query::BoundsKind::exact : query::BoundsKind::guaranteed});
  const query::QueryOutputs outputs = {arguments.query.jsonl,
                                       output::words_beside({arguments.query.jsonl})};
  const auto answered = query::run_frame_query(staged, input->frames, query, outputs);
  if (!answered) return answered.error();
  return arguments::ExitCode::success;
}

}  // namespace

void add_bounds(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "bounds",
                       "Compute boxes and spheres around the characters in every frame", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  scene::add_query_options(verb, arguments->query);
  verb.flag(
      "--exact", arguments->exact,
      "Compute the smallest box around the posed vertices that triangles use, exact to the bit");
  verb.option("--by", arguments->by, "What gets bounds: each instance, each part, or each joint",
              {.type = "instance|part|joint"});
  verb.runs([arguments] { return bounds(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
