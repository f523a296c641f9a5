#include "tools/pelt/query/closest_query.hpp"

#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/scene/surface_names.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

/// Equal distances are not closer, so the first collider wins.
bool is_closer(const PointOnCollider& a, const PointOnCollider& b) {
  return a.closest.distance < b.closest.distance;
}

}  // namespace

ClosestQuery::ClosestQuery(const scene::StagedScene& staged, std::vector<Vec3> points,
                           const DistanceSettings& settings)
    : staged_(staged),
      points_(std::move(points)),
      settings_(settings),
      found_(points_.size() * staged.colliders.size()),
      of_pose_(points_.size()),
      least_(points_.size()),
      least_frame_(points_.size()) {}

QueryStats ClosestQuery::ask(std::span<Pose> poses) {
  QueryStats work;
  for (std::uint32_t c = 0; c < poses.size(); ++c) {
    work +=
        closest_points(poses[c], points_, scratch_, of_pose_, {.max_distance = settings_.within});
    for (std::size_t p = 0; p < points_.size(); ++p)
      found_[p * poses.size() + c] = {c, of_pose_[p]};
  }
  return work;
}

/// Results of one point, by collider.
std::span<const PointOnCollider> ClosestQuery::of_point(std::size_t point) const {
  const std::size_t colliders = staged_.colliders.size();
  return std::span(found_).subspan(point * colliders, colliders);
}

void ClosestQuery::keep(std::uint32_t frame) {
  for (std::size_t p = 0; p < points_.size(); ++p)
    for (const PointOnCollider& point : of_point(p))
      if (is_closer(point, least_[p])) least_[p] = point, least_frame_[p] = frame;
}

ordered_json ClosestQuery::options_json() const {
  ordered_json from = ordered_json::array();
  for (const Vec3& point : points_) from.push_back(scene::vector_json(point));
  return {{"from", std::move(from)},
          {"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
          {"within", settings_.within}};  // infinity is written as null
}

void ClosestQuery::write_frame(scene::JsonLine& line) const {
  line.begin_list("points");
  for (std::size_t p = 0; p < points_.size(); ++p) {
    ordered_json closest = ordered_json::array();
    for (const PointOnCollider& point : of_point(p))
      if (point.closest) closest.push_back(point_json(point));
    line.item({{"point", p}, {"closest", std::move(closest)}});
  }
  line.end_list();
}

void ClosestQuery::write_totals(scene::JsonLine& line) const {
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

ordered_json ClosestQuery::point_json(const PointOnCollider& point) const {
  const SurfacePoint& on_surface = point.closest.point;
  const scene::NamedPoint named =
      scene::name_point(staged_, staged_.colliders[point.collider], on_surface);
  return {{"index", point.collider},    {"distance", point.closest.distance},
          {"triangle", named.triangle}, {"position", scene::vector_json(on_surface.position)},
          {"part", named.part},         {"joint", named.joint}};
}

void ClosestQuery::print(std::size_t frames, std::ostream& out) const {
  scene::label(out, "frames") << output::with_commas(frames) << '\n';
  for (std::size_t p = 0; p < points_.size(); ++p) {
    scene::label(out, ("point " + std::to_string(p)).c_str());
    const PointOnCollider& least = least_[p];
    if (!least.closest) {
      out << "nothing is within that distance\n";
      continue;
    }
    out << "closest in " << scene::frame_words(staged_.scene, least_frame_[p]) << ": "
        << output::fixed(least.closest.distance, 6) << " from "
        << scene::place_words(staged_, staged_.colliders[least.collider], least.closest.point)
        << '\n';
    scene::label(out, "") << "at" << scene::coordinates(least.closest.point.position) << '\n';
  }
}

}  // namespace pelt::tools::query
