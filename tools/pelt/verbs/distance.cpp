/// `pelt distance`: the distances of characters, frame by frame.

#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/query/distance_query.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/scene/staged_scene.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace pelt::tools::verbs {
namespace {

using nlohmann::ordered_json;

/// The closest point of a collider to a given point.
struct PointOnCollider {
  std::uint32_t collider = 0;
  ClosestPoint closest;
};

/// Equal distances are not closer, so the first collider wins.
bool is_closer(const PointOnCollider& a, const PointOnCollider& b) {
  return a.closest.distance < b.closest.distance;
}

/// Closest points on each collider, for each point: in the current frame, and over all frames.
class ClosestQuery final : public query::FrameQuery {
 public:
  ClosestQuery(const scene::StagedScene& staged, std::vector<Vec3> points,
               const query::DistanceSettings& settings)
      : staged_(staged),
        points_(std::move(points)),
        settings_(settings),
        found_(points_.size() * staged.colliders.size()),
        of_pose_(points_.size()),
        least_(points_.size()),
        least_frame_(points_.size()) {}

  QueryStats ask(std::span<Pose> poses) override {
    QueryStats work;
    for (std::uint32_t c = 0; c < poses.size(); ++c) {
      work +=
          closest_points(poses[c], points_, scratch_, of_pose_, {.max_distance = settings_.within});
      for (std::size_t p = 0; p < points_.size(); ++p)
        found_[p * poses.size() + c] = {c, of_pose_[p]};
    }
    return work;
  }

  void keep(std::uint32_t frame) override {
    for (std::size_t p = 0; p < points_.size(); ++p)
      for (const PointOnCollider& point : of_point(p))
        if (is_closer(point, least_[p])) least_[p] = point, least_frame_[p] = frame;
  }

  const char* format() const override { return "pelt-distance"; }

  ordered_json options_json() const override {
    ordered_json from = ordered_json::array();
    for (const Vec3& point : points_) from.push_back(scene::vector_json(point));
    return {{"from", std::move(from)},
            {"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
            {"within", settings_.within}};  // infinity is written as null
  }

  void write_frame(scene::JsonLine& line) const override {
    line.begin_list("points");
    for (std::size_t p = 0; p < points_.size(); ++p) {
      ordered_json closest = ordered_json::array();
      for (const PointOnCollider& point : of_point(p))
        if (point.closest) closest.push_back(point_json(point));
      line.item({{"point", p}, {"closest", std::move(closest)}});
    }
    line.end_list();
  }

  void write_totals(scene::JsonLine& line) const override {
    line.begin_list("least");
    for (std::size_t p = 0; p < points_.size(); ++p) {
      if (!least_[p].closest) continue;
      ordered_json entry = point_json(least_[p]);
      entry["point"] = p;
      scene::add_frame(staged_.scene, least_frame_[p], entry);
      line.item(entry);
    }
    line.end_list();
  }

  void print(const arguments::FrameRange& frames, std::ostream& out) const override {
    scene::label(out, "frames") << text::with_commas(frames.frames().size()) << '\n';
    for (std::size_t p = 0; p < points_.size(); ++p) {
      scene::label(out, ("point " + std::to_string(p)).c_str());
      const PointOnCollider& least = least_[p];
      if (!least.closest) {
        out << "nothing is within that distance\n";
        continue;
      }
      out << "closest in " << scene::frame_words(staged_.scene, least_frame_[p]) << ": "
          << text::fixed(least.closest.distance, 6) << " from "
          << scene::place_words(staged_, staged_.colliders[least.collider], least.closest.point)
          << '\n';
      scene::label(out, "") << "at" << scene::coordinates(least.closest.point.position) << '\n';
    }
  }

 private:
  /// Results of one point, by collider.
  std::span<const PointOnCollider> of_point(std::size_t point) const {
    const std::size_t colliders = staged_.colliders.size();
    return std::span(found_).subspan(point * colliders, colliders);
  }

  ordered_json point_json(const PointOnCollider& point) const {
    const SurfacePoint& on_surface = point.closest.point;
    const scene::NamedPoint named =
        scene::name_point(staged_, staged_.colliders[point.collider], on_surface);
    return {{"index", point.collider},    {"distance", point.closest.distance},
            {"triangle", named.triangle}, {"position", scene::vector_json(on_surface.position)},
            {"part", named.part},         {"joint", named.joint}};
  }

  scene::StagedScene staged_;
  std::vector<Vec3> points_;
  query::DistanceSettings settings_;
  Scratch scratch_;
  std::vector<PointOnCollider> found_;  // [points][colliders]
  std::vector<ClosestPoint> of_pose_;
  std::vector<PointOnCollider> least_;  // [points]
  std::vector<std::uint32_t> least_frame_;
};

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
  return text::number_not_allowed("--within", *within, "give a number from 0 to 1e12");
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

/// Distances from points if there are any, otherwise between colliders.
Result<arguments::ExitCode> run(const Arguments& arguments) {
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
  if (!points->empty())
    return query::run<ClosestQuery>(arguments.query, *granularity, *points, settings);
  using Lists = query::DistanceQuery::Lists;
  const Lists lists = arguments.query.jsonl.empty() ? Lists::closest : Lists::all;
  return query::run<query::DistanceQuery>(arguments.query, *granularity, settings, lists);
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
  verb.runs([arguments] { return run(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
