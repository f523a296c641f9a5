#include "tools/pelt/query/distance_query.hpp"

#include "tools/pelt/output/text.hpp"
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

/// Later pairs have no hint. A hint saves time and does not change the answer.
constexpr std::uint64_t kMostHints = 1 << 18;

}  // namespace

DistanceQuery::DistanceQuery(const scene::StagedScene& staged, const DistanceSettings& settings,
                             Lists lists)
    : staged_(staged),
      settings_(settings),
      lists_(lists),
      nearest_now_(kMostRows),
      nearest_(kMostRows) {
  const std::uint64_t n = staged.colliders.size();
  hints_.resize(std::min(n > 0 ? n * (n - 1) / 2 : 0, kMostHints));
}

QueryStats DistanceQuery::ask(std::span<Pose> poses) {
  QueryStats work;
  nearest_now_.clear();
  found_now_.clear();
  std::size_t next_hint = 0;
  for (std::uint32_t a = 0; a < poses.size(); ++a)
    for (std::uint32_t b = a + 1; b < poses.size(); ++b) {
      Distance* const hint = next_hint < hints_.size() ? &hints_[next_hint++] : nullptr;
      DistanceOptions options;
      options.max_distance = settings_.within;
      if (hint != nullptr && *hint) options.hint = hint;
      PairDistance pair = {.a = a, .b = b};
      work += pelt::distance(poses[a], poses[b], scratch_, pair.distance, options);
      if (hint != nullptr) *hint = pair.distance;
      if (pair.distance) found(pair);
    }
  return work;
}

void DistanceQuery::found(const PairDistance& pair) {
  nearest_now_.add(pair);
  if (lists_ == Lists::all) found_now_.push_back(pair);
}

/// Adding the nearest pairs of each frame suffices: a pair that is among the nearest of all frames
/// is among the nearest in the frame of its least distance.
void DistanceQuery::keep(std::uint32_t frame) {
  const auto in_this_frame = [&](PairDistance pair) {
    pair.frame = frame;
    return pair;
  };
  for (const PairDistance& pair : nearest_now_.pairs()) nearest_.add(in_this_frame(pair));
  for (const PairDistance& pair : found_now_) {
    const auto [least, is_new] = least_.try_emplace({pair.a, pair.b}, in_this_frame(pair));
    if (!is_new && pair.distance.distance < least->second.distance.distance)
      least->second = in_this_frame(pair);
  }
}

ordered_json DistanceQuery::options_json() const {
  return {{"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
          {"within", settings_.within}};  // infinity is written as null
}

ordered_json DistanceQuery::frame_json() const {
  ordered_json found = ordered_json::array();
  for (const PairDistance& pair : found_now_) found.push_back(pair_json(pair));
  return {{"pairs", std::move(found)}};
}

ordered_json DistanceQuery::totals_json() const {
  ordered_json list = ordered_json::array();
  for (const auto& [names, pair] : least_) {
    ordered_json& entry = list.emplace_back(pair_json(pair));
    entry["frame"] = pair.frame;
  }
  return {{"least", std::move(list)}};
}

ordered_json DistanceQuery::pair_json(const PairDistance& pair) const {
  const Distance& distance = pair.distance;
  const auto named = [&](std::uint32_t collider, const SurfacePoint& point) {
    return scene::name_point(staged_, staged_.colliders[collider], point);
  };
  const scene::NamedPoint a = named(pair.a, distance.a), b = named(pair.b, distance.b);
  return {{"a", pair.a},
          {"b", pair.b},
          {"distance", distance.distance},
          {"triangles", {a.triangle, b.triangle}},
          {"points",
           {scene::vector_json(distance.a.position), scene::vector_json(distance.b.position)}},
          {"parts", {a.part, b.part}},
          {"joints", {a.joint, b.joint}}};
}

void DistanceQuery::print(std::size_t frames, std::ostream& out) const {
  scene::label(out, "frames") << output::with_commas(frames) << '\n';
  if (staged_.colliders.size() < 2) {
    scene::print_too_few(staged_.scene, settings_.granularity, out);
    return;
  }
  if (nearest_.pairs().empty()) {
    scene::label(out, "distance") << "nothing is within that distance\n";
    return;
  }
  const auto place = [&](std::uint32_t collider, const SurfacePoint& point) {
    return scene::place_words(staged_, staged_.colliders[collider], point);
  };
  out << "\nleast distances\n";
  for (const PairDistance& pair : nearest_.pairs()) {
    const Distance& distance = pair.distance;
    out << std::right << std::setw(12) << output::fixed(distance.distance, 6) << "  frame "
        << pair.frame << "  " << place(pair.a, distance.a) << "  " << place(pair.b, distance.b)
        << '\n';
  }
  out << '\n';
}

}  // namespace pelt::tools::query
