#include "tools/pelt/query/distance_query.hpp"

#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/scene/surface_names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <tuple>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

/// Later pairs have no hint. A hint saves time and does not change the answer.
constexpr std::size_t kMaxHints = 1 << 18;

bool is_before(const PairDistance& x, const PairDistance& y) {
  return std::tie(x.a, x.b) < std::tie(y.a, y.b);
}

/// Replaces distances in `least` by shorter ones of `found`, and adds the pairs that are new. Both
/// are in order of pairs.
void keep_least(std::span<const PairDistance> found, std::vector<PairDistance>& least) {
  const auto known_end = static_cast<std::ptrdiff_t>(least.size());
  std::size_t known = 0;
  for (const PairDistance& pair : found) {
    const auto end = static_cast<std::size_t>(known_end);
    while (known < end && is_before(least[known], pair)) ++known;
    if (known == end || is_before(pair, least[known]))
      least.push_back(pair);
    else if (pair.distance.distance < least[known].distance.distance)
      least[known] = pair;
  }
  std::inplace_merge(least.begin(), least.begin() + known_end, least.end(), is_before);
}

}  // namespace

QueryStats DistanceQuery::ask(std::span<Pose> poses) {
  closest_now_.clear();
  found_.clear();
  next_hint_ = 0;
  QueryStats work;
  if (settings_.within < DistanceSettings().within) {
    for (const auto& [a, b] : near_pairs_.find(poses, settings_.within))
      work += ask_pair(poses, a, b);
    return work;
  }
  for (std::uint32_t a = 0; a < poses.size(); ++a)
    for (std::uint32_t b = a + 1; b < poses.size(); ++b) work += ask_pair(poses, a, b);
  return work;
}

QueryStats DistanceQuery::ask_pair(std::span<Pose> poses, std::uint32_t a, std::uint32_t b) {
  PairDistance pair = {.a = a, .b = b};
  const DistanceOptions options = {.max_distance = settings_.within, .hint = find_hint(pair)};
  const QueryStats work = pelt::distance(poses[a], poses[b], scratch_, pair.distance, options);
  if (!pair.distance) return work;
  closest_now_.add(pair);
  if (lists_ == Lists::all || found_.size() < kMaxHints) found_.push_back(pair);
  return work;
}

/// Pairs ascend, so hints of earlier pairs are not needed any more.
const Distance* DistanceQuery::find_hint(const PairDistance& pair) {
  while (next_hint_ < hints_.size() && is_before(hints_[next_hint_], pair)) ++next_hint_;
  const bool is_known = next_hint_ < hints_.size() && !is_before(pair, hints_[next_hint_]);
  return is_known ? &hints_[next_hint_].distance : nullptr;
}

/// Adding the closest pairs of each frame suffices: a pair that is among the closest of all frames
/// is among the closest in the frame of its least distance.
void DistanceQuery::keep(std::uint32_t frame) {
  for (PairDistance pair : closest_now_.pairs()) {
    pair.frame = frame;
    closest_.add(pair);
  }
  for (PairDistance& pair : found_) pair.frame = frame;
  if (lists_ == Lists::all) keep_least(found_, least_);
  hints_.assign(found_.begin(),
                found_.begin() + static_cast<std::ptrdiff_t>(std::min(found_.size(), kMaxHints)));
}

ordered_json DistanceQuery::options_json() const {
  return {{"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
          {"within", settings_.within}};  // infinity is written as null
}

void DistanceQuery::write_frame(scene::JsonLine& line) const {
  line.begin_list("pairs");
  for (const PairDistance& pair : found_) line.item(pair_json(pair));
  line.end_list();
}

void DistanceQuery::write_totals(scene::JsonLine& line) const {
  line.begin_list("least");
  for (const PairDistance& pair : least_) {
    ordered_json entry = pair_json(pair);
    entry["frame"] = pair.frame;
    line.item(entry);
  }
  line.end_list();
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
  if (closest_.pairs().empty()) {
    scene::label(out, "distance") << "nothing is within that distance\n";
    return;
  }
  const auto place = [&](std::uint32_t collider, const SurfacePoint& point) {
    return scene::place_words(staged_, staged_.colliders[collider], point);
  };
  out << "\nleast distances\n";
  for (const PairDistance& pair : closest_.pairs()) {
    const Distance& distance = pair.distance;
    out << std::right << std::setw(12) << output::fixed(distance.distance, 6) << "  frame "
        << pair.frame << "  " << place(pair.a, distance.a) << "  " << place(pair.b, distance.b)
        << '\n';
  }
  out << '\n';
}

}  // namespace pelt::tools::query
