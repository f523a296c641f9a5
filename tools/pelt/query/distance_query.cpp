#include "tools/pelt/query/distance_query.hpp"

#include "text/format.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/staged_scene.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <tuple>
#include <utility>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

bool is_before(const PairDistance& x, const PairDistance& y) {
  return std::tie(x.a, x.b) < std::tie(y.a, y.b);
}

PairDistance in_frame(PairDistance pair, std::uint32_t frame) {
  pair.frame = frame;
  return pair;
}

/// Appends the pairs of `least`, with shorter distances of `found` in their place, and the pairs
/// that only `found` has. All lists are in order of pairs.
void merge_least(const PairList& found, std::uint32_t frame, const PairList& least,
                 PairList& merged) {
  PairReader new_pairs(found), known_pairs(least);
  const PairDistance *pair = new_pairs.next(), *known = known_pairs.next();
  while (pair != nullptr || known != nullptr) {
    const bool is_known = known != nullptr && (pair == nullptr || !is_before(*pair, *known));
    const bool is_found = pair != nullptr && (known == nullptr || !is_before(*known, *pair));
    if (is_found && !(is_known && known->distance.distance <= pair->distance.distance))
      merged.push_back(in_frame(*pair, frame));
    else
      merged.push_back(*known);
    if (is_found) pair = new_pairs.next();
    if (is_known) known = known_pairs.next();
  }
}

/// The option that lists more than `rows` pairs.
std::string option_for_more(std::uint32_t rows) {
  if (rows == DistanceSettings::kMostRows) return "--jsonl";
  return "--list " + std::to_string(std::min(2 * rows, DistanceSettings::kMostRows));
}

void set_vector(ordered_json& json, const Vec3& v) { json[0] = v.x, json[1] = v.y, json[2] = v.z; }

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
  if (lists_ == Lists::all || found_.size() < most_hints_) found_.push_back(pair);
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
  for (const PairDistance& pair : closest_now_.pairs()) closest_.add(in_frame(pair, frame));
  if (lists_ == Lists::all) {
    merged_.clear();
    merge_least(found_, frame, least_, merged_);
    std::swap(least_, merged_);
  }
  hints_.assign(found_.first().begin(), found_.first().end());
}

Result<void> DistanceQuery::status() const {
  for (const PairList* list : {&found_, &least_, &merged_})
    if (const auto stored = list->status(); !stored) return stored;
  return {};
}

ordered_json DistanceQuery::options_json() const {
  return {{"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
          {"within", settings_.within}};  // infinity is written as null
}

void DistanceQuery::write_frame(scene::JsonLine& line) const {
  line.begin_list("pairs");
  PairReader pairs(found_);
  ordered_json entry;
  while (const PairDistance* pair = pairs.next()) {
    set_pair(*pair, entry);
    line.item(entry);
  }
  line.end_list();
}

void DistanceQuery::write_totals(scene::JsonLine& line) const {
  line.begin_list("least");
  PairReader pairs(least_);
  ordered_json entry;
  while (const PairDistance* pair = pairs.next()) {
    set_pair(*pair, entry);
    scene::add_frame(staged_.scene, pair->frame, entry);
    line.item(entry);
  }
  line.end_list();
}

/// All pairs of a list use one object: building an object costs more than writing its text.
void DistanceQuery::set_pair(const PairDistance& pair, ordered_json& entry) const {
  const Distance& distance = pair.distance;
  const auto named = [&](std::uint32_t collider, const SurfacePoint& point) {
    return scene::name_point(staged_, staged_.colliders[collider], point);
  };
  scene::NamedPoint a = named(pair.a, distance.a), b = named(pair.b, distance.b);
  entry["a"] = pair.a;
  entry["b"] = pair.b;
  entry["distance"] = distance.distance;
  entry["triangles"][0] = a.triangle;
  entry["triangles"][1] = b.triangle;
  set_vector(entry["points"][0], distance.a.position);
  set_vector(entry["points"][1], distance.b.position);
  entry["parts"][0] = std::move(a.part);
  entry["parts"][1] = std::move(b.part);
  entry["joints"][0] = std::move(a.joint);
  entry["joints"][1] = std::move(b.joint);
}

void DistanceQuery::print(const arguments::FrameRange& frames, std::ostream& out) const {
  scene::label(out, "frames") << text::with_commas(frames.frames().size()) << '\n';
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
    out << std::right << std::setw(12) << text::fixed(distance.distance, 6) << "  "
        << scene::frame_words(staged_.scene, pair.frame) << "  " << place(pair.a, distance.a)
        << "  " << place(pair.b, distance.b) << '\n';
  }
  if (closest_.has_left_out() || closest_now_.has_left_out())
    out << std::right << std::setw(12) << "..."
        << " and more: " << option_for_more(settings_.rows_listed) << '\n';
  out << '\n';
}

}  // namespace pelt::tools::query
