#include "tools/pelt/query/ray_query.hpp"

#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

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
                                 << asset::printable_name(names.part(first.instance, hit))
                                 << ", triangle " << hit.triangle << ", "
                                 << asset::printable_name(scenes::joint_name(
                                        names.asset_of(first.instance), joints[0].joint))
                                 << '\n';
  scene::label(out, "") << "t " << output::fixed(double{hit.t}, 6) << " at"
                        << scene::coordinates(point_of(ray, hit.t)) << ", normal"
                        << scene::coordinates(hit.normal) << '\n';
}

void print_ray(const HitNames& names, const RaySettings& settings, std::size_t number,
               const RayTally& tally, std::size_t frames, std::ostream& out) {
  scene::label(out, ("ray " + std::to_string(number)).c_str());
  if (!tally.first_hit) {
    out << "hits nothing in " << output::counted(frames, "frame") << '\n';
    return;
  }
  out << "hits in " << output::with_commas(tally.frames.size()) << " of "
      << output::counted(frames, "frame") << ": "
      << scene::frame_runs(names.staged().scene, tally.frames, settings.stride) << '\n';
  print_first(names, settings.rays[number], *tally.first_hit, out);
}

}  // namespace

QueryStats RayQuery::ask(std::span<Pose> poses) {
  QueryStats work;
  for (std::size_t i = 0; i < poses.size(); ++i)
    work += cast(poses[i], settings_.rays, hits_.of_instance(i), settings_.facing);
  return work;
}

void RayQuery::keep(std::uint32_t frame) {
  for (std::size_t r = 0; r < tallies_.size(); ++r) tallies_[r].add(frame, hits_, r);
}

ordered_json RayQuery::options_json() const {
  constexpr const char* kFacings[] = {"both", "front", "back"};
  ordered_json rays = ordered_json::array();
  for (const Ray& ray : settings_.rays)
    rays.push_back({{"from", scene::vector_json(ray.origin)},
                    {"direction", scene::vector_json(ray.direction)}});
  return {{"rays", std::move(rays)},
          {"beyond", settings_.rays[0].t_max > 1},
          {"facing", kFacings[static_cast<int>(settings_.facing)]}};
}

void RayQuery::write_frame(scene::JsonLine& line) const {
  const HitNames names(staged_);
  line.begin_list("rays");
  for (std::size_t r = 0; r < hits_.ray_count(); ++r)
    line.item(ray_json(names, settings_.rays[r], r, hits_));
  line.end_list();
}

void RayQuery::write_totals(scene::JsonLine& line) const {
  line.begin_list("frames_hit");
  for (const RayTally& tally : tallies_) line.item(tally.frames.size());
  line.end_list();
}

void RayQuery::print(std::size_t frames, std::ostream& words) const {
  const HitNames names(staged_);
  for (std::size_t r = 0; r < tallies_.size(); ++r)
    print_ray(names, settings_, r, tallies_[r], frames, words);
}

}  // namespace pelt::tools::query
