#include "tools/pelt/query/nearest_scene.hpp"

#include <pelt/distance.hpp>

#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/answer_frames.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/scene/surface_names.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

/// Nearest point of a collider to a point.
struct Nearest {
  std::uint32_t collider = 0;
  ClosestPoint closest;
};

/// Nearest first means: of what is equally near the first collider.
bool is_nearer(const Nearest& a, const Nearest& b) {
  return a.closest.distance < b.closest.distance;
}

/// Nearest points on each collider, for each point: in the current frame, and over all frames.
class NearestQuery {
 public:
  NearestQuery(std::span<const Vec3> points, std::uint32_t colliders, double within)
      : points_(points),
        options_{within},
        found_(points.size() * colliders),
        of_pose_(points.size()),
        least_(points.size()),
        least_frame_(points.size()) {}

  QueryStats ask(std::span<Pose> poses) {
    QueryStats work;
    for (std::uint32_t c = 0; c < poses.size(); ++c) {
      work += closest_points(poses[c], points_, scratch_, of_pose_, options_);
      for (std::size_t p = 0; p < points_.size(); ++p)
        found_[p * poses.size() + c] = {c, of_pose_[p]};
    }
    return work;
  }

  /// Results of one point, by collider.
  std::span<const Nearest> of_point(std::size_t point) const {
    const std::size_t colliders = found_.size() / points_.size();
    return std::span(found_).subspan(point * colliders, colliders);
  }

  void keep(std::uint32_t frame) {
    for (std::size_t p = 0; p < points_.size(); ++p)
      for (const Nearest& nearest : of_point(p))
        if (is_nearer(nearest, least_[p])) least_[p] = nearest, least_frame_[p] = frame;
  }

  const NearestQuery& answers() const { return *this; }
  std::span<const Vec3> points() const { return points_; }
  const Nearest& least(std::size_t point) const { return least_[point]; }
  std::uint32_t least_frame(std::size_t point) const { return least_frame_[point]; }

 private:
  std::span<const Vec3> points_;
  ClosestPointOptions options_;
  Scratch scratch_;
  std::vector<Nearest> found_;  // [points][colliders]
  std::vector<ClosestPoint> of_pose_;
  std::vector<Nearest> least_;  // [points]
  std::vector<std::uint32_t> least_frame_;
};

class NearestWriter {
 public:
  NearestWriter(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                std::ostream& out)
      : scene_(scene), colliders_(colliders), out_(out) {}

  void header(std::span<const Vec3> points, const DistanceSettings& settings) {
    const arguments::FrameRange& frames = settings.frames;
    ordered_json from = ordered_json::array();
    for (const Vec3& point : points) from.push_back(scene::vector_json(point));
    ordered_json header = scene::header_json("pelt-distance", scene_, colliders_);
    header["options"] = {
        {"from", std::move(from)},
        {"by", settings.granularity == scene::Granularity::part ? "part" : "instance"},
        {"within", settings.within},  // infinity is written as null
        {"frames", {frames.begin, frames.end, frames.stride}},
        {"fps", scene_.fps}};
    scene::write_line(header, out_);
  }

  void frame(std::uint32_t frame, const NearestQuery& query) {
    ordered_json points = ordered_json::array();
    for (std::size_t p = 0; p < query.points().size(); ++p) {
      ordered_json places = ordered_json::array();
      for (const Nearest& nearest : query.of_point(p))
        if (nearest.closest.found()) places.push_back(place_json(nearest));
      points.push_back({{"point", p}, {"places", std::move(places)}});
    }
    scene::write_line({{"frame", frame},
                       {"time", scenes::frame_time(scene_, frame)},
                       {"points", std::move(points)}},
                      out_);
  }

  void totals(const NearestQuery& query, const scene::FrameCosts& costs) {
    ordered_json least = ordered_json::array();
    for (std::size_t p = 0; p < query.points().size(); ++p) {
      if (!query.least(p).closest.found()) continue;
      ordered_json& entry = least.emplace_back(place_json(query.least(p)));
      entry["point"] = p;
      entry["frame"] = query.least_frame(p);
    }
    scene::write_line({{"totals", {{"frames", costs.seconds.size()}, {"least", std::move(least)}}},
                       {"counters", scene::counters_json(costs.work)}},
                      out_);
  }

 private:
  ordered_json place_json(const Nearest& nearest) const {
    const SurfacePoint& point = nearest.closest.point;
    const scene::NamedPoint named = scene::name_point(scene_, colliders_[nearest.collider], point);
    return {{"index", nearest.collider},  {"distance", nearest.closest.distance},
            {"triangle", named.triangle}, {"position", scene::vector_json(point.position)},
            {"part", named.part},         {"joint", named.joint}};
  }

  const scenes::Scene& scene_;
  std::span<const scene::Collider> colliders_;
  std::ostream& out_;
};

void print_summary(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                   const NearestQuery& query, const scene::FrameCosts& costs, std::ostream& out) {
  scene::print_scene(scene, colliders, out);
  scene::label(out, "frames") << output::with_commas(costs.seconds.size()) << '\n';
  for (std::size_t p = 0; p < query.points().size(); ++p) {
    scene::label(out, ("point " + std::to_string(p)).c_str());
    const Nearest& least = query.least(p);
    if (!least.closest.found()) {
      out << "nothing is within that distance\n";
      continue;
    }
    out << "nearest in frame " << query.least_frame(p) << ": "
        << output::fixed(least.closest.distance, 6) << " from "
        << scene::place_words(scene, colliders[least.collider], least.closest.point) << '\n';
    scene::label(out, "") << "at" << scene::coordinates(least.closest.point.position) << '\n';
  }
  scene::print_costs(costs.seconds, costs.work, out);
}

}  // namespace

Result<void> nearest_scene(const scenes::Scene& scene, std::span<const Vec3> points,
                           const DistanceSettings& settings,
                           const arguments::ModelArguments& models, const std::string& jsonl,
                           std::ostream& words) {
  const auto colliders = scene::make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  output::LineOutput lines;
  if (const auto opened = lines.open(jsonl); !opened) return opened.error();
  std::optional<NearestWriter> writer;
  if (lines.stream() != nullptr) writer.emplace(scene, *colliders, *lines.stream());
  if (writer) writer->header(points, settings);
  NearestQuery query(points, static_cast<std::uint32_t>(colliders->size()), settings.within);
  const Result<scene::FrameCosts> costs =
      answer_frames(scene, *colliders, settings.frames, query, writer, lines);
  if (!costs) return costs.error();
  print_summary(scene, *colliders, query, *costs, words);
  output::print_written(jsonl, words);
  return {};
}

}  // namespace pelt::tools::query
