#include "tools/pelt/query/region_scene.hpp"

#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/answer_frames.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iomanip>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

/// Placement of a collider in the current frame, and number of frames per placement.
struct Placed {
  Placement placement = Placement::outside;
  TrianglesInRegion triangles;
  std::array<std::uint32_t, 3> frames = {};       ///< by placement
  std::vector<std::uint32_t> frames_not_outside;  ///< their numbers
};

class RegionQuery {
 public:
  RegionQuery(const RegionSettings& settings, std::size_t colliders)
      : region_(settings.region.region()),
        finds_triangles_(settings.finds_triangles),
        placed_(colliders) {}

  QueryStats ask(std::span<Pose> poses) {
    QueryStats work;
    for (std::size_t c = 0; c < poses.size(); ++c) {
      const Classified found = classify(poses[c], region_, scratch_);
      placed_[c].placement = found.placement;
      work += found.stats;
      if (finds_triangles_)
        work += find_triangles(poses[c], region_, scratch_, placed_[c].triangles);
    }
    return work;
  }

  void keep(std::uint32_t frame) {
    for (Placed& placed : placed_) {
      ++placed.frames[static_cast<std::size_t>(placed.placement)];
      if (placed.placement != Placement::outside) placed.frames_not_outside.push_back(frame);
    }
  }

  std::span<const Placed> answers() const { return placed_; }

 private:
  Region region_;
  bool finds_triangles_;
  Scratch scratch_;
  std::vector<Placed> placed_;
};

class RegionWriter {
 public:
  RegionWriter(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
               const RegionSettings& settings, std::ostream& out)
      : scene_(scene), colliders_(colliders), settings_(settings), out_(out) {}

  void header() {
    const arguments::FrameRange& frames = settings_.frames;
    ordered_json header = scene::header_json("pelt-region", scene_, colliders_);
    header["options"] = {
        {settings_.region.kind(), settings_.region.numbers()},
        {"by", settings_.granularity == scene::Granularity::part ? "part" : "instance"},
        {"triangles", settings_.finds_triangles},
        {"frames", {frames.begin, frames.end, frames.stride}},
        {"fps", scene_.fps}};
    scene::write_line(header, out_);
  }

  void frame(std::uint32_t frame, std::span<const Placed> placed) {
    ordered_json placements = ordered_json::array();
    for (std::size_t c = 0; c < placed.size(); ++c) {
      ordered_json& entry = placements.emplace_back();
      entry["index"] = c;
      entry["placement"] = name_of(placed[c].placement);
      if (!settings_.finds_triangles) continue;
      entry["touching"] = numbers_in_model(c, placed[c].triangles.touching);
      entry["inside"] = numbers_in_model(c, placed[c].triangles.inside);
    }
    scene::write_line({{"frame", frame},
                       {"time", scenes::frame_time(scene_, frame)},
                       {"placements", std::move(placements)}},
                      out_);
  }

  void totals(std::span<const Placed> placed, const scene::FrameCosts& costs) {
    ordered_json placements = ordered_json::array();
    for (std::size_t c = 0; c < placed.size(); ++c) {
      ordered_json& entry = placements.emplace_back();
      entry["index"] = c;
      for (const Placement p : {Placement::outside, Placement::partly, Placement::inside})
        entry[name_of(p)] = placed[c].frames[static_cast<std::size_t>(p)];
    }
    scene::write_line(
        {{"totals", {{"frames", costs.seconds.size()}, {"placements", std::move(placements)}}},
         {"counters", scene::counters_json(costs.work)}},
        out_);
  }

 private:
  ordered_json numbers_in_model(std::size_t collider,
                                std::span<const std::uint32_t> triangles) const {
    ordered_json numbers = ordered_json::array();
    for (const std::uint32_t t : triangles)
      numbers.push_back(t + colliders_[collider].first_triangle);
    return numbers;
  }

  const scenes::Scene& scene_;
  std::span<const scene::Collider> colliders_;
  const RegionSettings& settings_;
  std::ostream& out_;
};

void print_placements(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                      std::span<const Placed> placed, std::uint32_t stride, std::ostream& out) {
  std::vector<std::string> names;
  std::size_t width = 0;
  for (const scene::Collider& collider : colliders) {
    names.push_back(scene::collider_name(scene, collider));
    width = std::max(width, names.back().size());
  }
  const auto column = [&](auto text) -> std::ostream& { return out << std::setw(9) << text; };
  out << "\nframes\n  " << std::string(width, ' ') << std::right;
  for (const Placement p : {Placement::outside, Placement::partly, Placement::inside})
    column(name_of(p));
  out << '\n';
  for (std::size_t c = 0; c < placed.size(); ++c) {
    out << "  " << std::left << std::setw(static_cast<int>(width)) << names[c] << std::right;
    for (const std::uint32_t frames : placed[c].frames) column(frames);
    if (!placed[c].frames_not_outside.empty())
      out << "  not outside in " << scene::frame_runs(placed[c].frames_not_outside, stride);
    out << '\n';
  }
  out << '\n';
}

}  // namespace

Result<void> region_scene(const scenes::Scene& scene, const RegionSettings& settings,
                          const arguments::ModelArguments& models, const std::string& jsonl,
                          std::ostream& words) {
  const auto colliders = scene::make_colliders(scene, settings.granularity, models);
  if (!colliders) return colliders.error();
  output::LineOutput lines;
  if (const auto opened = lines.open(jsonl); !opened) return opened.error();
  std::optional<RegionWriter> writer;
  if (lines.stream() != nullptr) writer.emplace(scene, *colliders, settings, *lines.stream());
  if (writer) writer->header();
  RegionQuery query(settings, colliders->size());
  const Result<scene::FrameCosts> costs =
      answer_frames(scene, *colliders, settings.frames, query, writer, lines);
  if (!costs) return costs.error();
  scene::print_scene(scene, *colliders, words);
  print_placements(scene, *colliders, query.answers(), settings.frames.stride, words);
  scene::print_costs(costs->seconds, costs->work, words);
  output::print_written(jsonl, words);
  return {};
}

}  // namespace pelt::tools::query
