/// `pelt distance`: the distances of characters, frame by frame.

#include "asset/message.hpp"
#include "tools/pelt/arguments/position_argument.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/closest_query.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/verbs/commands.hpp"

namespace pelt::tools::verbs {
namespace {

struct Arguments {
  scene::QueryArguments query;
  std::string by = "instance";
  std::optional<double> within;
  std::uint32_t list = query::DistanceSettings().rows_listed;
  std::vector<std::string> from;
};

constexpr const char* kFooter = R"(
Examples:
  pelt distance scene.json
  pelt distance knight.glb barbarian.glb --clip Walk --clip Attack --at 0,0,-0.5 --at 0,0,0.5
  pelt distance scene.json --frames 0:9 --within 0.5 --jsonl distances.jsonl
  pelt distance scene.json --from 0,1,0 --from 0.5,1,0

Reports the least distance between the triangles of every two instances, and the closest points. The
distance is 0 if and only if `pelt check` finds a contact. Of equally close pairs of triangles, the one
with the lowest triangle numbers is reported. Distances are between surfaces: an instance that is wholly
inside another has a positive distance from it. With --from, reports the distance of each point from
each instance, and the closest point of the surface.)";

Result<double> choose_within(const std::optional<double>& within) {
  if (!within) return query::DistanceSettings().within;
  if (*within >= 0 && *within <= 1e12) return *within;
  return output::number_not_allowed("--within", *within, "give a number from 0 to 1e12");
}

Result<std::vector<Vec3>> parse_points(std::span<const std::string> texts) {
  std::vector<Vec3> points;
  for (const std::string& text : texts) {
    const Result<Vec3> point = arguments::parse_point("--from", text);
    if (!point) return point.error();
    points.push_back(*point);
  }
  return points;
}

Result<arguments::ExitCode> run(const scene::StagedScene& staged,
                                const arguments::FrameRange& frames, query::FrameQuery& query,
                                const query::QueryOutputs& outputs) {
  const auto answered = query::run_frame_query(staged, frames, query, outputs);
  if (!answered) return answered.error();
  return arguments::ExitCode::success;
}

/// Runs the query from points if there are any, otherwise between colliders.
Result<arguments::ExitCode> answer(const scene::StagedScene& staged,
                                   const std::vector<Vec3>& points,
                                   const query::DistanceSettings& settings,
                                   const arguments::FrameRange& frames,
                                   const query::QueryOutputs& outputs) {
  if (!points.empty()) {
    query::ClosestQuery query(staged, points, settings);
    return run(staged, frames, query, outputs);
  }
  using Lists = query::DistanceQuery::Lists;
  query::DistanceQuery query(staged, settings, outputs.jsonl.empty() ? Lists::closest : Lists::all);
  return run(staged, frames, query, outputs);
}

Result<arguments::ExitCode> distance(const Arguments& arguments) {
  query::DistanceSettings settings;
  const Result<scene::Granularity> granularity = scene::choose_granularity(arguments.by);
  if (!granularity) return granularity.error();
  settings.granularity = *granularity;
  const Result<double> within = choose_within(arguments.within);
  if (!within) return within.error();
  settings.within = *within;
  settings.rows_listed = arguments.list;
  const Result<std::vector<Vec3>> points = parse_points(arguments.from);
  if (!points) return points.error();
  const Result<scene::QueryInput> input = scene::open_query(arguments.query);
  if (!input) return input.error();
  const auto colliders =
      scene::make_colliders(input->scene, *granularity, arguments.query.scene.models);
  if (!colliders) return colliders.error();
  const scene::StagedScene staged = {input->scene, *colliders};
  const query::QueryOutputs outputs = {arguments.query.jsonl,
                                       output::words_beside({arguments.query.jsonl})};
  return answer(staged, *points, settings, input->frames, outputs);
}

}  // namespace

void add_distance(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "distance",
                       "Compute the least distances between characters in every frame", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  scene::add_query_options(verb, arguments->query);
  verb.option(
      "--by", arguments->by,
      "Compute distances between every two instances, or every two parts, including parts of the "
      "same instance",
      {.type = "instance|part"});
  verb.option("--within", arguments->within, "Leave out pairs that are farther apart (faster)",
              {.type = "DISTANCE"});
  verb.option("--list", arguments->list, "Show at most N rows in the summary",
              {.type = "N", .least = 1, .most = query::DistanceSettings::kMostRows});
  verb.option("--from", arguments->from, "Compute distances from this point instead (repeatable)",
              {.type = "X,Y,Z", .excludes = "--list"});
  verb.runs([arguments] { return distance(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
