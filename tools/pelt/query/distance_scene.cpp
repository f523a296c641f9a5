#include "tools/pelt/query/distance_scene.hpp"

#include <pelt/distance.hpp>

#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/answer_frames.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/scene/surface_names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostRows = 10;

/// The distance of two colliders: in the current frame, and the least one of all frames.
struct PairDistance {
  std::uint32_t a = 0, b = 0;
  Distance now = {};
  Distance least = {};
  std::uint32_t least_frame = 0;
};

class DistanceQuery {
 public:
  DistanceQuery(std::uint32_t colliders, double within) {
    options_.max_distance = within;
    for (std::uint32_t a = 0; a < colliders; ++a)
      for (std::uint32_t b = a + 1; b < colliders; ++b) pairs_.push_back({.a = a, .b = b});
  }

  QueryStats ask(std::span<Pose> poses) {
    QueryStats work;
    for (PairDistance& pair : pairs_) {
      const Distance before = pair.now;
      DistanceOptions options = options_;
      if (before.found()) options.hint = &before;
      work += pelt::distance(poses[pair.a], poses[pair.b], scratch_, pair.now, options);
    }
    return work;
  }

  void keep(std::uint32_t frame) {
    for (PairDistance& pair : pairs_) {
      if (!(pair.now.distance < pair.least.distance)) continue;
      pair.least = pair.now;
      pair.least_frame = frame;
    }
  }

  std::span<const PairDistance> answers() const { return pairs_; }

 private:
  DistanceOptions options_;
  Scratch scratch_;
  std::vector<PairDistance> pairs_;
};

class DistanceWriter {
 public:
  DistanceWriter(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                 std::ostream& out)
      : scene_(scene), colliders_(colliders), out_(out) {}

  void header(const DistanceSettings& settings) {
    const arguments::FrameRange& frames = settings.frames;
    ordered_json header = scene::header_json("pelt-distance", scene_, colliders_);
    header["options"] = {
        {"by", settings.granularity == scene::Granularity::part ? "part" : "instance"},
        {"within", settings.within},  // infinity is written as null
        {"frames", {frames.begin, frames.end, frames.stride}},
        {"fps", scene_.fps}};
    scene::write_line(header, out_);
  }

  void frame(std::uint32_t frame, std::span<const PairDistance> pairs) {
    ordered_json found = ordered_json::array();
    for (const PairDistance& pair : pairs) {
      if (pair.now.found()) found.push_back(pair_json(pair, pair.now));
    }
    scene::write_line({{"frame", frame},
                       {"time", scenes::frame_time(scene_, frame)},
                       {"pairs", std::move(found)}},
                      out_);
  }

  void totals(std::span<const PairDistance> pairs, const scene::FrameCosts& costs) {
    ordered_json least = ordered_json::array();
    for (const PairDistance& pair : pairs) {
      if (!pair.least.found()) continue;
      ordered_json& entry = least.emplace_back(pair_json(pair, pair.least));
      entry["frame"] = pair.least_frame;
    }
    scene::write_line({{"totals", {{"frames", costs.seconds.size()}, {"least", std::move(least)}}},
                       {"counters", scene::counters_json(costs.work)}},
                      out_);
  }

 private:
  ordered_json pair_json(const PairDistance& pair, const Distance& distance) const {
    const scene::NamedPoint a = scene::name_point(scene_, colliders_[pair.a], distance.a);
    const scene::NamedPoint b = scene::name_point(scene_, colliders_[pair.b], distance.b);
    return {{"a", pair.a},
            {"b", pair.b},
            {"distance", distance.distance},
            {"triangles", {a.triangle, b.triangle}},
            {"points",
             {scene::vector_json(distance.a.position), scene::vector_json(distance.b.position)}},
            {"parts", {a.part, b.part}},
            {"joints", {a.joint, b.joint}}};
  }

  const scenes::Scene& scene_;
  std::span<const scene::Collider> colliders_;
  std::ostream& out_;
};

/// Pairs that are found at all, the nearest first.
std::vector<PairDistance> nearest_pairs(std::span<const PairDistance> pairs) {
  std::vector<PairDistance> nearest;
  for (const PairDistance& pair : pairs) {
    if (pair.least.found()) nearest.push_back(pair);
  }
  std::stable_sort(nearest.begin(), nearest.end(), [](const auto& a, const auto& b) {
    return a.least.distance < b.least.distance;
  });
  if (nearest.size() > kMostRows) nearest.resize(kMostRows);
  return nearest;
}

void print_nearest(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                   std::span<const PairDistance> pairs, std::ostream& out) {
  const std::vector<PairDistance> nearest = nearest_pairs(pairs);
  if (nearest.empty()) {
    scene::label(out, "distance") << "nothing is within that distance\n";
    return;
  }
  out << "\nleast distances\n";
  for (const PairDistance& pair : nearest) {
    out << std::right << std::setw(12) << output::fixed(pair.least.distance, 6) << "  frame "
        << pair.least_frame << "  " << scene::place_words(scene, colliders[pair.a], pair.least.a)
        << "  " << scene::place_words(scene, colliders[pair.b], pair.least.b) << '\n';
  }
  out << '\n';
}

void print_summary(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                   std::span<const PairDistance> pairs, const DistanceSettings& settings,
                   const scene::FrameCosts& costs, std::ostream& out) {
  scene::print_scene(scene, colliders, out);
  scene::label(out, "frames") << output::with_commas(costs.seconds.size()) << '\n';
  if (pairs.empty()) {
    scene::print_too_few(scene, settings.granularity, out);
  } else {
    print_nearest(scene, colliders, pairs, out);
  }
  scene::print_costs(costs.seconds, costs.work, out);
}

}  // namespace

Result<void> distance_scene(const scenes::Scene& scene, const DistanceSettings& settings,
                            const arguments::ModelArguments& models, const std::string& jsonl,
                            std::ostream& words) {
  const auto colliders = scene::make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  output::LineOutput lines;
  if (const auto opened = lines.open(jsonl); !opened) return opened.error();
  std::optional<DistanceWriter> writer;
  if (lines.stream() != nullptr) writer.emplace(scene, *colliders, *lines.stream());
  if (writer) writer->header(settings);
  DistanceQuery query(static_cast<std::uint32_t>(colliders->size()), settings.within);
  const Result<scene::FrameCosts> costs =
      answer_frames(scene, *colliders, settings.frames, query, writer, lines);
  if (!costs) return costs.error();
  print_summary(scene, *colliders, query.answers(), settings, *costs, words);
  output::print_written(jsonl, words);
  return {};
}

}  // namespace pelt::tools::query
