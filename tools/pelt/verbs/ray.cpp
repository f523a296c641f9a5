/// `pelt ray`: the first hits of rays, frame by frame.

#include <pelt/ray.hpp>

#include "scenes/names.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/query/frame_query.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <nlohmann/json.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace pelt::tools::verbs {
namespace {

using nlohmann::ordered_json;

struct RaySettings {
  std::vector<Ray> rays;
  Facing facing = Facing::both;
};

/// First hit of each ray on each instance.
class RayHits {
 public:
  RayHits(std::size_t rays, std::size_t instances) : rays_(rays), hits_(rays * instances) {}

  std::span<RayHit> of_instance(std::size_t instance) {
    return std::span(hits_).subspan(instance * rays_, rays_);
  }

  const RayHit& at(std::size_t instance, std::size_t ray) const {
    return hits_[instance * rays_ + ray];
  }

  /// The instance that a ray hits first.
  std::optional<std::uint32_t> first(std::size_t ray) const {
    std::optional<std::uint32_t> first;
    for (std::uint32_t i = 0; i * rays_ < hits_.size(); ++i) {
      if (at(i, ray) && (!first || at(i, ray).t < at(*first, ray).t)) first = i;
    }
    return first;
  }

  std::size_t ray_count() const { return rays_; }
  std::size_t instance_count() const { return hits_.size() / rays_; }

 private:
  std::size_t rays_;
  std::vector<RayHit> hits_;
};

/// Summary of a ray: frames with hits, and the least t of all frames.
struct RayTally {
  struct First {
    std::uint32_t frame = 0, instance = 0;
    RayHit hit;
  };
  std::vector<std::uint32_t> frames;
  std::optional<First> first_hit;

  void add(std::uint32_t frame, const RayHits& hits, std::size_t ray) {
    const std::optional<std::uint32_t> first = hits.first(ray);
    if (!first) return;
    frames.push_back(frame);
    const RayHit& hit = hits.at(*first, ray);
    if (!first_hit || hit.t < first_hit->hit.t) first_hit = {frame, *first, hit};
  }
};

Vec3 point_of(const Ray& ray, float t) {
  const auto at = [t](float origin, float direction) {
    return static_cast<float>(double{origin} + double{t} * double{direction});
  };
  return {at(ray.origin.x, ray.direction.x), at(ray.origin.y, ray.direction.y),
          at(ray.origin.z, ray.direction.z)};
}

/// Formats hits as text and JSON, with the names of the scene.
class HitNames {
 public:
  HitNames(const scene::StagedScene& staged) : staged_(staged) {}

  const scene::StagedScene& staged() const { return staged_; }

  std::string instance(std::uint32_t instance) const {
    return scene::collider_name(staged_, staged_.colliders[instance]);
  }

  const asset::Asset& asset_of(std::uint32_t instance) const { return staged_.asset_of(instance); }

  std::string part(std::uint32_t instance, const RayHit& hit) const {
    const asset::Asset& asset = asset_of(instance);
    const auto part = &asset.part_of(hit.triangle) - asset.parts.data();
    return staged_.names->part(staged_.character_of(instance), static_cast<std::uint32_t>(part));
  }

  std::vector<JointShare> joints(std::uint32_t instance, const RayHit& hit) const {
    std::vector<JointShare> shares;
    influences_at(staged_.colliders[instance].model, hit, shares);
    return shares;
  }

 private:
  scene::StagedScene staged_;
};

ordered_json hit_json(const HitNames& names, std::uint32_t instance, const Ray& ray,
                      const RayHit& hit) {
  ordered_json joints = ordered_json::array();
  for (const JointShare& share : names.joints(instance, hit)) {
    joints.push_back({{"joint", scenes::joint_name(names.asset_of(instance), share.joint)},
                      {"share", share.share}});
  }
  return {{"index", instance},
          {"part", names.part(instance, hit)},
          {"triangle", hit.triangle},
          {"t", hit.t},
          {"point", scene::vector_json(point_of(ray, hit.t))},
          {"normal", scene::vector_json(hit.normal)},
          {"weights", hit.barycentrics},
          {"joints", std::move(joints)}};
}

ordered_json ray_json(const HitNames& names, const Ray& ray, std::size_t number,
                      const RayHits& hits) {
  ordered_json entry = {{"ray", number}, {"first", nullptr}};
  if (const auto first = hits.first(number)) entry["first"] = *first;
  ordered_json& found = entry["hits"] = ordered_json::array();
  for (std::uint32_t i = 0; i < hits.instance_count(); ++i) {
    if (const RayHit& hit = hits.at(i, number)) found.push_back(hit_json(names, i, ray, hit));
  }
  return entry;
}

void print_first(const HitNames& names, const Ray& ray, const RayTally::First& first,
                 std::ostream& out) {
  const RayHit& hit = first.hit;
  const std::vector<JointShare> joints = names.joints(first.instance, hit);
  scene::label(out, "first hit") << scene::frame_words(names.staged().scene, first.frame) << ": "
                                 << names.instance(first.instance) << ' '
                                 << text::printable_name(names.part(first.instance, hit))
                                 << ", triangle " << hit.triangle << ", "
                                 << text::printable_name(scenes::joint_name(
                                        names.asset_of(first.instance), joints[0].joint))
                                 << '\n';
  scene::label(out, "") << "t " << text::fixed(double{hit.t}, 6) << " at"
                        << scene::coordinates(point_of(ray, hit.t)) << ", normal"
                        << scene::coordinates(hit.normal) << '\n';
}

void print_ray(const HitNames& names, const RaySettings& settings, std::size_t number,
               const RayTally& tally, const arguments::FrameRange& frames, std::ostream& out) {
  const std::string all = text::counted(frames.frames().size(), "frame");
  scene::label(out, ("ray " + std::to_string(number)).c_str());
  if (!tally.first_hit) {
    out << "hits nothing in " << all << '\n';
    return;
  }
  out << "hits in " << text::with_commas(tally.frames.size()) << " of " << all << ": "
      << scene::frame_runs(names.staged().scene, tally.frames, frames.stride) << '\n';
  print_first(names, settings.rays[number], *tally.first_hit, out);
}

class RayQuery final : public query::FrameQuery {
 public:
  RayQuery(const scene::StagedScene& staged, const RaySettings& settings)
      : staged_(staged),
        settings_(settings),
        hits_(settings.rays.size(), staged.colliders.size()),
        tallies_(settings.rays.size()) {}

  QueryStats ask(std::span<Pose> poses) override {
    QueryStats work;
    for (std::size_t i = 0; i < poses.size(); ++i)
      work += cast(poses[i], settings_.rays, hits_.of_instance(i), settings_.facing);
    return work;
  }

  void keep(std::uint32_t frame) override {
    for (std::size_t r = 0; r < tallies_.size(); ++r) tallies_[r].add(frame, hits_, r);
  }

  const char* format() const override { return "pelt-ray"; }

  ordered_json options_json() const override {
    constexpr const char* kFacings[] = {"both", "front", "back"};
    ordered_json rays = ordered_json::array();
    for (const Ray& ray : settings_.rays)
      rays.push_back({{"from", scene::vector_json(ray.origin)},
                      {"direction", scene::vector_json(ray.direction)}});
    return {{"rays", std::move(rays)},
            {"beyond", settings_.rays[0].t_max > 1},
            {"facing", kFacings[static_cast<int>(settings_.facing)]}};
  }

  void write_frame(scene::JsonLine& line) const override {
    const HitNames names(staged_);
    line.begin_list("rays");
    for (std::size_t r = 0; r < hits_.ray_count(); ++r)
      line.item(ray_json(names, settings_.rays[r], r, hits_));
    line.end_list();
  }

  void write_totals(scene::JsonLine& line) const override {
    line.begin_list("frames_hit");
    for (const RayTally& tally : tallies_) line.item(tally.frames.size());
    line.end_list();
  }

  void print(const arguments::FrameRange& frames, std::ostream& words) const override {
    const HitNames names(staged_);
    for (std::size_t r = 0; r < tallies_.size(); ++r)
      print_ray(names, settings_, r, tallies_[r], frames, words);
  }

 private:
  scene::StagedScene staged_;
  RaySettings settings_;
  RayHits hits_;
  std::vector<RayTally> tallies_;  // of each ray
};

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
  return text::bad_argument("--facing", "unknown value " + text::quoted(name),
                            "give both, front or back");
}

Result<Ray> parse_ray(const std::string& from, const std::string& to, bool beyond) {
  const Result<Vec3> begin = arguments::parse_point("--from", from);
  if (!begin) return begin.error();
  const Result<Vec3> end = arguments::parse_point("--to", to);
  if (!end) return end.error();
  if (*begin == *end) {
    return text::bad_argument("--to", text::quoted(to) + " is the same point as --from",
                              "give another point");
  }
  Ray ray = segment(*begin, *end);
  if (beyond) ray.t_max = std::numeric_limits<float>::infinity();
  return ray;
}

Result<std::vector<Ray>> parse_rays(const Arguments& arguments) {
  if (arguments.from.size() != arguments.to.size()) {
    return text::bad_argument("--to",
                              "was given " + text::counted(arguments.to.size(), "time") +
                                  " and --from " + text::counted(arguments.from.size(), "time"),
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

Result<arguments::ExitCode> run(const Arguments& arguments) {
  const Result<Facing> facing = choose_facing(arguments.facing);
  if (!facing) return facing.error();
  const Result<std::vector<Ray>> rays = parse_rays(arguments);
  if (!rays) return rays.error();
  return query::run<RayQuery>(arguments.query, scene::Granularity::instance,
                              RaySettings{*rays, *facing});
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
  verb.runs([arguments] { return run(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
