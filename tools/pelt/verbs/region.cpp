/// `pelt region`: the characters in a region of space, frame by frame.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/query/region_query.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/verbs/commands.hpp"

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  scene::QueryArguments query;
  arguments::RegionArguments region;
  std::string by = "instance";
  bool triangles = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt region scene.json --camera 0,1,4,0,1,0 --angle 40
  pelt region scene.json --sphere 0,0.5,0,0.3 --frames 20:21 --triangles --jsonl -
  pelt region knight.glb --clip Walk --box -1,0,-1,1,2,1 --by part
  pelt region scene.json --capsule 0,0,0,0,1,0,0.2

Outside: no triangle touches the region. Inside: all triangles lie wholly in the region. Otherwise:
partly. The answer is exact. Region and triangles are closed sets, so touching counts.)";

Result<arguments::ExitCode> region(const Arguments& arguments) {
  Result<arguments::ChosenRegion> chosen = arguments::choose_region(arguments.region);
  if (!chosen) return chosen.error();
  const Result<scene::Granularity> granularity = scene::choose_granularity(arguments.by);
  if (!granularity) return granularity.error();
  const Result<scene::QueryInput> input = scene::open_query(arguments.query);
  if (!input) return input.error();
  const auto colliders =
      scene::make_colliders(input->scene, *granularity, arguments.query.scene.models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {input->scene, *colliders};
  query::RegionQuery query(
      staged, {std::move(*chosen), *granularity, arguments.triangles, input->frames.stride});
  const query::QueryOutputs outputs = {arguments.query.jsonl,
                                       output::words_beside({arguments.query.jsonl})};
  const auto answered = query::run_frame_query(staged, input->frames, query, outputs);
  if (!answered) return answered.error();
  return arguments::ExitCode::success;
}

}  // namespace

void add_region(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(
      app, "region",
      "Find which characters are in a box, a ball, a capsule or the view of a camera", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  scene::add_query_options(verb, arguments->query);
  arguments::add_region_options(verb, arguments->region);
  verb.option("--by", arguments->by, "What is tested: each instance, or each part",
              {.type = "instance|part"});
  verb.flag("--triangles", arguments->triangles,
            "Also write the triangles that touch the region and those inside");
  verb.runs([arguments] { return region(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
