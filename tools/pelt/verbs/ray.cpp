/// `pelt ray`: the first hits of rays, frame by frame.

#include "asset/message.hpp"
#include "tools/pelt/arguments/position_argument.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/ray_query.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <limits>

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  scene::QueryArguments query;
  std::vector<std::string> from, to;
  bool beyond = false;
  std::string facing = "both";
};

constexpr const char* kFooter = R"(
Examples:
  pelt ray scene.json --from 0,0.5,-3 --to 0,0.5,3
  pelt ray scene.json --frames 20:21 --from -2,0.5,0 --to 2,0.5,0 --from 0,9,0 --to 0,8,0 --beyond
  pelt ray knight.glb --clip Walk --from 0,0.5,-3 --to 0,0.5,3 --facing front --jsonl -

Rays are watertight: no ray slips between triangles that share an edge or a vertex. t is 0 at --from
and 1 at --to. If a ray hits several instances or triangles at the same t, the one with the lowest
number is reported.)";

Result<Facing> choose_facing(const std::string& name) {
  if (name == "both") return Facing::both;
  if (name == "front") return Facing::front;
  if (name == "back") return Facing::back;
  return output::bad_argument("--facing", "unknown value " + asset::quoted(name),
                              "give both, front or back");
}

Result<Ray> parse_ray(const std::string& from, const std::string& to, bool beyond) {
  const Result<Vec3> begin = arguments::parse_point("--from", from);
  if (!begin) return begin.error();
  const Result<Vec3> end = arguments::parse_point("--to", to);
  if (!end) return end.error();
  if (*begin == *end) {
    return output::bad_argument("--to", asset::quoted(to) + " is the same point as --from",
                                "give another point");
  }
  Ray ray = segment(*begin, *end);
  if (beyond) ray.t_max = std::numeric_limits<float>::infinity();
  return ray;
}

Result<std::vector<Ray>> parse_rays(const Arguments& arguments) {
  if (arguments.from.size() != arguments.to.size()) {
    return output::bad_argument("--to",
                                "was given " + output::counted(arguments.to.size(), "time") +
                                    " and --from " + output::counted(arguments.from.size(), "time"),
                                "give both options for each ray");
  }
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < arguments.from.size(); ++i) {
    const Result<Ray> ray = parse_ray(arguments.from[i], arguments.to[i], arguments.beyond);
    if (!ray) return ray.error();
    rays.push_back(*ray);
  }
  return rays;
}

Result<arguments::ExitCode> ray(const Arguments& arguments) {
  query::RaySettings settings;
  const Result<Facing> facing = choose_facing(arguments.facing);
  if (!facing) return facing.error();
  settings.facing = *facing;
  const Result<std::vector<Ray>> rays = parse_rays(arguments);
  if (!rays) return rays.error();
  settings.rays = *rays;
  const Result<scene::QueryInput> input = scene::open_query(arguments.query);
  if (!input) return input.error();
  settings.stride = input->frames.stride;
  const auto colliders = scene::make_colliders(input->scene, scene::Granularity::instance,
                                               arguments.query.scene.models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {input->scene, *colliders};
  query::RayQuery query(staged, settings);
  const query::QueryOutputs outputs = {arguments.query.jsonl,
                                       output::words_beside({arguments.query.jsonl})};
  const auto answered = query::run_frame_query(staged, input->frames, query, outputs);
  if (!answered) return answered.error();
  return arguments::ExitCode::success;
}

}  // namespace

void add_ray(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "ray", "Find the first hits of rays in every frame", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  scene::add_query_options(verb, arguments->query);
  verb.option("--from", arguments->from, "Start of a ray (repeatable, with one --to each)",
              {.type = "X,Y,Z", .is_required = true});
  verb.option("--to", arguments->to, "End of the ray", {.type = "X,Y,Z", .is_required = true});
  verb.flag("--beyond", arguments->beyond, "Continue rays beyond --to");
  verb.option("--facing", arguments->facing,
              "Which side of a triangle can be hit; its vertices appear counter-clockwise from the "
              "front",
              {.type = "both|front|back"});
  verb.runs([arguments] { return ray(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
