#include "tools/pelt/query/bounds_scene.hpp"

#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/query/answer_frames.hpp"
#include "tools/pelt/query/bounds_query.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

class BoundsWriter {
 public:
  BoundsWriter(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
               std::ostream& out)
      : scene_(scene), colliders_(colliders), out_(out) {}

  void header(const BoundsSettings& settings) {
    constexpr const char* kNames[] = {"instance", "part", "joint"};
    const arguments::FrameRange& frames = settings.frames;
    ordered_json header = scene::header_json("pelt-bounds", scene_, colliders_);
    header["options"] = {{"by", kNames[static_cast<int>(settings.by)]},
                         {"exact", settings.kind == BoundsKind::exact},
                         {"frames", {frames.begin, frames.end, frames.stride}},
                         {"fps", scene_.fps}};
    scene::write_line(header, out_);
  }

  void frame(std::uint32_t frame, std::span<const Bounded> bounded) {
    ordered_json bounds = ordered_json::array();
    for (const Bounded& b : bounded) {
      ordered_json& entry = bounds.emplace_back(named(b));
      entry["box"] = box_json(b.box);
      if (!b.sphere) continue;
      entry["sphere"] = {{"centre", scene::vector_json(b.sphere->centre)},
                         {"radius", b.sphere->radius}};
    }
    scene::write_line({{"frame", frame},
                       {"time", scenes::frame_time(scene_, frame)},
                       {"bounds", std::move(bounds)}},
                      out_);
  }

  void totals(std::span<const Bounded> bounded, const scene::FrameCosts& costs) {
    ordered_json bounds = ordered_json::array();
    for (const Bounded& b : bounded) bounds.emplace_back(named(b))["box"] = box_json(b.all_frames);
    scene::write_line(
        {{"totals", {{"frames", costs.seconds.size()}, {"bounds", std::move(bounds)}}},
         {"counters", scene::counters_json(costs.work)}},
        out_);
  }

 private:
  ordered_json named(const Bounded& bounded) const {
    const scene::Collider& collider = colliders_[bounded.collider];
    ordered_json entry = {{"index", bounded.collider}};
    const std::uint32_t character = scene_.instances[collider.instance].character;
    if (bounded.joint)
      entry["joint"] = scenes::joint_name(scene_.characters[character].asset, *bounded.joint);
    return entry;
  }

  static ordered_json box_json(const Box& box) {
    return {{"low", scene::vector_json(box.low)}, {"high", scene::vector_json(box.high)}};
  }

  const scenes::Scene& scene_;
  std::span<const scene::Collider> colliders_;
  std::ostream& out_;
};

std::string name_of(const scenes::Scene& scene, const scene::Collider& collider,
                    const Bounded& bounded) {
  const std::string name = scene::collider_name(scene, collider);
  if (!bounded.joint) return name;
  const std::uint32_t character = scene.instances[collider.instance].character;
  const asset::Asset& asset = scene.characters[character].asset;
  return name + " " + asset::printable_name(scenes::joint_name(asset, *bounded.joint));
}

void print_boxes(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                 std::span<const Bounded> bounded, std::ostream& out) {
  std::vector<std::string> names;
  std::size_t width = 0;
  for (const Bounded& b : bounded) {
    names.push_back(name_of(scene, colliders[b.collider], b));
    width = std::max(width, names.back().size());
  }
  out << "\nminimum and maximum x, y, z over all frames"
      << (bounded.empty() || !bounded[0].sphere ? "" : "; largest radius") << '\n';
  for (std::size_t i = 0; i < bounded.size(); ++i) {
    const Bounded& b = bounded[i];
    out << "  " << std::left << std::setw(static_cast<int>(width)) << names[i] << "  "
        << scene::coordinates(b.all_frames.low) << "  " << scene::coordinates(b.all_frames.high);
    if (b.sphere) out << "  " << output::fixed(static_cast<double>(b.largest_radius), 3);
    out << '\n';
  }
  out << '\n';
}

void print_summary(const scenes::Scene& scene, std::span<const scene::Collider> colliders,
                   const BoundsSettings& settings, std::span<const Bounded> bounded,
                   const scene::FrameCosts& costs, std::ostream& out) {
  scene::print_scene(scene, colliders, out);
  scene::label(out, "bounds") << (settings.kind == BoundsKind::exact ? "exact" : "guaranteed")
                              << ", in " << output::counted(costs.seconds.size(), "frame") << '\n';
  print_boxes(scene, colliders, bounded, out);
  scene::print_costs(costs.seconds, costs.work, out);
}

}  // namespace

Result<void> bounds_scene(const scenes::Scene& scene, const BoundsSettings& settings,
                          const arguments::ModelArguments& models, const std::string& jsonl,
                          std::ostream& words) {
  const auto granularity =
      settings.by == BoundsBy::part ? scene::Granularity::part : scene::Granularity::instance;
  const auto colliders = scene::make_colliders(scene, granularity, models);
  if (!colliders) return colliders.error();
  output::LineOutput lines;
  if (const auto opened = lines.open(jsonl); !opened) return opened.error();
  std::optional<BoundsWriter> writer;
  if (lines.stream() != nullptr) writer.emplace(scene, *colliders, *lines.stream());
  if (writer) writer->header(settings);
  BoundsQuery query(*colliders, settings);
  const Result<scene::FrameCosts> costs =
      answer_frames(scene, *colliders, settings.frames, query, writer, lines);
  if (!costs) return costs.error();
  print_summary(scene, *colliders, settings, query.answers(), *costs, words);
  output::print_written(jsonl, words);
  return {};
}

}  // namespace pelt::tools::query
