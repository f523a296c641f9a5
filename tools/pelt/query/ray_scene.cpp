#include "tools/pelt/query/ray_scene.hpp"

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "tools/pelt/output/line_output.hpp"
#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

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

Vec3 point_of(const Ray& ray, float t) {
  const auto at = [t](float origin, float direction) {
    return static_cast<float>(double{origin} + double{t} * double{direction});
  };
  return {at(ray.origin.x, ray.direction.x), at(ray.origin.y, ray.direction.y),
          at(ray.origin.z, ray.direction.z)};
}

/// Summary of a ray: frames with hits, and the least t of all frames.
struct RayTally {
  struct Nearest {
    std::uint32_t frame = 0, instance = 0;
    RayHit hit;
  };
  std::vector<std::uint32_t> frames;
  std::optional<Nearest> nearest;

  void add(std::uint32_t frame, const RayHits& hits, std::size_t ray) {
    const std::optional<std::uint32_t> first = hits.first(ray);
    if (!first) return;
    frames.push_back(frame);
    const RayHit& hit = hits.at(*first, ray);
    if (!nearest || hit.t < nearest->hit.t) nearest = {frame, *first, hit};
  }
};

/// Hits in words and as JSON, by the names of the scene.
class HitNames {
 public:
  HitNames(const scenes::Scene& scene, std::span<const scene::Collider> colliders)
      : scene_(scene), colliders_(colliders) {}

  const scenes::Scene& scene() const { return scene_; }
  std::span<const scene::Collider> colliders() const { return colliders_; }

  const asset::Asset& asset_of(std::uint32_t instance) const {
    return scene_.characters[scene_.instances[instance].character].asset;
  }

  std::string part(std::uint32_t instance, const RayHit& hit) const {
    const asset::Asset& asset = asset_of(instance);
    const auto part = &asset.part_of(hit.triangle) - asset.parts.data();
    return scenes::part_name(asset, static_cast<std::uint32_t>(part));
  }

  std::vector<JointShare> joints(std::uint32_t instance, const RayHit& hit) const {
    std::vector<JointShare> shares;
    influences_at(colliders_[instance].model, hit, shares);
    return shares;
  }

 private:
  const scenes::Scene& scene_;
  std::span<const scene::Collider> colliders_;
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
          {"weights", hit.weights},
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

ordered_json options_json(const scenes::Scene& scene, const RaySettings& settings) {
  constexpr const char* kFacings[] = {"both", "front", "back"};
  ordered_json rays = ordered_json::array();
  for (const Ray& ray : settings.rays) {
    rays.push_back({{"from", scene::vector_json(ray.origin)},
                    {"direction", scene::vector_json(ray.direction)}});
  }
  const arguments::FrameRange& frames = settings.frames;
  return {{"rays", std::move(rays)},
          {"beyond", settings.rays[0].t_max > 1},
          {"facing", kFacings[static_cast<int>(settings.facing)]},
          {"frames", {frames.begin, frames.end, frames.stride}},
          {"fps", scene.fps}};
}

void write_header(const HitNames& names, const RaySettings& settings, std::ostream& out) {
  ordered_json header = scene::header_json("pelt-ray", names.scene(), names.colliders());
  header["options"] = options_json(names.scene(), settings);
  scene::write_line(header, out);
}

void write_frame(const HitNames& names, const RaySettings& settings, std::uint32_t frame,
                 const RayHits& hits, std::ostream& out) {
  ordered_json rays = ordered_json::array();
  for (std::size_t r = 0; r < hits.ray_count(); ++r)
    rays.push_back(ray_json(names, settings.rays[r], r, hits));
  scene::write_line({{"frame", frame},
                     {"time", scenes::frame_time(names.scene(), frame)},
                     {"rays", std::move(rays)}},
                    out);
}

void write_totals(std::span<const RayTally> tallies, const scene::FrameCosts& costs,
                  std::ostream& out) {
  ordered_json frames_hit = ordered_json::array();
  for (const RayTally& tally : tallies) frames_hit.push_back(tally.frames.size());
  scene::write_line(
      {{"totals", {{"frames", costs.seconds.size()}, {"frames_hit", std::move(frames_hit)}}},
       {"counters", scene::counters_json(costs.work)}},
      out);
}

void print_nearest(const HitNames& names, const Ray& ray, const RayTally::Nearest& nearest,
                   std::ostream& out) {
  const RayHit& hit = nearest.hit;
  const std::vector<JointShare> joints = names.joints(nearest.instance, hit);
  scene::label(out, "nearest") << "frame " << nearest.frame << ": "
                               << scene::collider_name(names.scene(),
                                                       names.colliders()[nearest.instance])
                               << ' ' << asset::printable_name(names.part(nearest.instance, hit))
                               << ", triangle " << hit.triangle << ", "
                               << asset::printable_name(scenes::joint_name(
                                      names.asset_of(nearest.instance), joints[0].joint))
                               << '\n';
  scene::label(out, "") << "t " << output::fixed(double{hit.t}, 6) << " at"
                        << scene::coordinates(point_of(ray, hit.t)) << ", normal"
                        << scene::coordinates(hit.normal) << '\n';
}

void print_ray(const HitNames& names, const RaySettings& settings, std::size_t number,
               const RayTally& tally, std::size_t frames, std::ostream& out) {
  scene::label(out, ("ray " + std::to_string(number)).c_str());
  if (!tally.nearest) {
    out << "hits nothing in " << output::counted(frames, "frame") << '\n';
    return;
  }
  out << "hits in " << output::with_commas(tally.frames.size()) << " of "
      << output::counted(frames, "frame") << ": "
      << scene::frame_runs(tally.frames, settings.frames.stride) << '\n';
  print_nearest(names, settings.rays[number], *tally.nearest, out);
}

void print_summary(const HitNames& names, const RaySettings& settings,
                   std::span<const RayTally> tallies, const scene::FrameCosts& costs,
                   std::ostream& out) {
  scene::print_scene(names.scene(), names.colliders(), out);
  for (std::size_t r = 0; r < tallies.size(); ++r)
    print_ray(names, settings, r, tallies[r], costs.seconds.size(), out);
  scene::print_costs(costs.seconds, costs.work, out);
}

QueryStats cast_at_all(std::span<Pose> poses, const RaySettings& settings, RayHits& hits) {
  QueryStats work;
  for (std::size_t i = 0; i < poses.size(); ++i)
    work += cast(poses[i], settings.rays, hits.of_instance(i), {settings.facing});
  return work;
}

}  // namespace

Result<void> ray_scene(const scenes::Scene& scene, const RaySettings& settings,
                       const arguments::ModelArguments& models, const std::string& jsonl,
                       std::ostream& words) {
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, models);
  if (!colliders) return colliders.error();
  const HitNames names(scene, *colliders);
  output::LineOutput lines;
  if (const auto opened = lines.open(jsonl); !opened) return opened.error();
  if (lines.stream() != nullptr) write_header(names, settings, *lines.stream());
  RayHits hits(settings.rays.size(), colliders->size());
  std::vector<RayTally> tallies(settings.rays.size());
  const auto record = [&](std::uint32_t frame) {
    for (std::size_t r = 0; r < tallies.size(); ++r) tallies[r].add(frame, hits, r);
    if (lines.stream() != nullptr) write_frame(names, settings, frame, hits, *lines.stream());
  };
  const auto ask = [&](std::span<Pose> poses) { return cast_at_all(poses, settings, hits); };
  const Result<scene::FrameCosts> costs =
      scene::run_frames(scene, *colliders, settings.frames, {ask, record});
  if (!costs) return asset::prefixed(scene.name, costs.error());
  if (lines.stream() != nullptr) write_totals(tallies, *costs, *lines.stream());
  if (const auto closed = lines.close(); !closed) return closed.error();
  print_summary(names, settings, tallies, *costs, words);
  output::print_written(jsonl, words);
  return {};
}

}  // namespace pelt::tools::query
