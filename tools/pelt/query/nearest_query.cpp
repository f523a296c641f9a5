#include "tools/pelt/query/nearest_query.hpp"

#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/scene/surface_names.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

/// Equal distances are not nearer, so the first collider wins.
bool is_nearer(const Nearest& a, const Nearest& b) {
  return a.closest.distance < b.closest.distance;
}

}  // namespace

NearestQuery::NearestQuery(const scene::StagedScene& staged, std::vector<Vec3> points,
                           const DistanceSettings& settings)
    : staged_(staged),
      points_(std::move(points)),
      settings_(settings),
      found_(points_.size() * staged.colliders.size()),
      of_pose_(points_.size()),
      least_(points_.size()),
      least_frame_(points_.size()) {}

QueryStats NearestQuery::ask(std::span<Pose> poses) {
  QueryStats work;
  for (std::uint32_t c = 0; c < poses.size(); ++c) {
    work += closest_points(poses[c], points_, scratch_, of_pose_, {settings_.within});
    for (std::size_t p = 0; p < points_.size(); ++p)
      found_[p * poses.size() + c] = {c, of_pose_[p]};
  }
  return work;
}

/// Results of one point, by collider.
std::span<const Nearest> NearestQuery::of_point(std::size_t point) const {
  const std::size_t colliders = staged_.colliders.size();
  return std::span(found_).subspan(point * colliders, colliders);
}

void NearestQuery::keep(std::uint32_t frame) {
  for (std::size_t p = 0; p < points_.size(); ++p)
    for (const Nearest& nearest : of_point(p))
      if (is_nearer(nearest, least_[p])) least_[p] = nearest, least_frame_[p] = frame;
}

ordered_json NearestQuery::options_json() const {
  ordered_json from = ordered_json::array();
  for (const Vec3& point : points_) from.push_back(scene::vector_json(point));
  return {{"from", std::move(from)},
          {"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
          {"within", settings_.within}};  // infinity is written as null
}

void NearestQuery::write_frame(scene::JsonLine& line) const {
  line.begin_list("points");
  for (std::size_t p = 0; p < points_.size(); ++p) {
    ordered_json places = ordered_json::array();
    for (const Nearest& nearest : of_point(p))
      if (nearest.closest) places.push_back(place_json(nearest));
    line.item({{"point", p}, {"places", std::move(places)}});
  }
  line.end_list();
}

void NearestQuery::write_totals(scene::JsonLine& line) const {
  line.begin_list("least");
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (!least_[p].closest) continue;
    ordered_json entry = place_json(least_[p]);
    entry["point"] = p;
    entry["frame"] = least_frame_[p];
    line.item(entry);
  }
  line.end_list();
}

ordered_json NearestQuery::place_json(const Nearest& nearest) const {
  const SurfacePoint& point = nearest.closest.point;
  const scene::NamedPoint named =
      scene::name_point(staged_, staged_.colliders[nearest.collider], point);
  return {{"index", nearest.collider},  {"distance", nearest.closest.distance},
          {"triangle", named.triangle}, {"position", scene::vector_json(point.position)},
          {"part", named.part},         {"joint", named.joint}};
}

void NearestQuery::print(std::size_t frames, std::ostream& out) const {
  scene::label(out, "frames") << output::with_commas(frames) << '\n';
  for (std::size_t p = 0; p < points_.size(); ++p) {
    scene::label(out, ("point " + std::to_string(p)).c_str());
    const Nearest& least = least_[p];
    if (!least.closest) {
      out << "nothing is within that distance\n";
      continue;
    }
    out << "nearest in frame " << least_frame_[p] << ": "
        << output::fixed(least.closest.distance, 6) << " from "
        << scene::place_words(staged_, staged_.colliders[least.collider], least.closest.point)
        << '\n';
    scene::label(out, "") << "at" << scene::coordinates(least.closest.point.position) << '\n';
  }
}

}  // namespace pelt::tools::query
