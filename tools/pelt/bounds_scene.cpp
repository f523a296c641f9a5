#include "tools/pelt/bounds_scene.hpp"

#include <pelt/bounds.hpp>
#include <pelt/groups.hpp>

#include "asset/message.hpp"
#include "tools/pelt/json_lines.hpp"
#include "tools/pelt/scene_poses.hpp"
#include "tools/pelt/summary_lines.hpp"
#include "tools/pelt/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <limits>

namespace pelt::tools {
namespace {

using nlohmann::ordered_json;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr Box kEmptyBox = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

Box united(const Box& a, const Box& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

/// Something that has bounds: a collider, or what one of its joints moves.
struct Bounded {
  std::uint32_t collider = 0;
  std::optional<std::uint32_t> joint = std::nullopt;
  Box box = {};
  std::optional<Sphere> sphere = std::nullopt;  ///< joints have none
  Box all_frames = kEmptyBox;
  float largest_radius = 0;
};

class BoundsQuery {
 public:
  BoundsQuery(std::span<const Collider> colliders, const BoundsSettings& settings)
      : kind_(settings.kind) {
    for (std::uint32_t c = 0; c < colliders.size(); ++c) {
      if (settings.by == BoundsBy::joint) {
        add_joints(c, colliders[c].model);
      } else {
        bounded_.push_back({.collider = c});
      }
    }
  }

  QueryStats ask(std::span<Pose> poses) {
    QueryStats work;
    for (Bounded& bounded : bounded_) {
      Pose& pose = poses[bounded.collider];
      if (bounded.joint) {
        bounded.box = joint_box(pose, groups_[bounded.collider], *bounded.joint);
      } else {
        const Bounds found = kind_ == BoundsKind::exact ? tight_bounds(pose) : pelt::bounds(pose);
        bounded.box = found.box;
        bounded.sphere = found.sphere;
        work += found.stats;
      }
    }
    return work;
  }

  /// Keeps what all frames together need.
  void unite() {
    for (Bounded& bounded : bounded_) {
      bounded.all_frames = united(bounded.all_frames, bounded.box);
      if (bounded.sphere)
        bounded.largest_radius = std::max(bounded.largest_radius, bounded.sphere->radius);
    }
  }

  std::span<const Bounded> bounded() const { return bounded_; }

 private:
  void add_joints(std::uint32_t collider, const SkinnedModel& model) {
    groups_.push_back(group_by_joint(model));
    for (std::uint32_t j = 0; j < groups_.back().count(); ++j) {
      if (groups_.back().vertex_count(j) > 0)
        bounded_.push_back({.collider = collider, .joint = j});
    }
  }

  Box joint_box(const Pose& pose, const Groups& groups, std::uint32_t joint) const {
    return kind_ == BoundsKind::exact ? tight_group_bounds(pose, groups, joint)
                                      : group_bounds(pose, groups, joint);
  }

  BoundsKind kind_;
  std::vector<Groups> groups_;  // of each collider, by joint only
  std::vector<Bounded> bounded_;
};

class BoundsWriter {
 public:
  BoundsWriter(const scenes::Scene& scene, std::span<const Collider> colliders, std::ostream& out)
      : scene_(scene), colliders_(colliders), out_(out) {}

  void header(const BoundsSettings& settings) {
    constexpr const char* kNames[] = {"instance", "part", "joint"};
    const FrameRange& frames = settings.frames;
    ordered_json header = header_json("pelt-bounds", scene_, colliders_);
    header["options"] = {{"by", kNames[static_cast<int>(settings.by)]},
                         {"exact", settings.kind == BoundsKind::exact},
                         {"frames", {frames.begin, frames.end, frames.stride}},
                         {"fps", scene_.fps}};
    write_line(header, out_);
  }

  void frame(std::uint32_t frame, std::span<const Bounded> bounded) {
    ordered_json bounds = ordered_json::array();
    for (const Bounded& b : bounded) {
      ordered_json& entry = bounds.emplace_back(named(b));
      entry["box"] = box_json(b.box);
      if (!b.sphere) continue;
      entry["sphere"] = {{"centre", vector_json(b.sphere->centre)}, {"radius", b.sphere->radius}};
    }
    write_line({{"frame", frame},
                {"time", scenes::frame_time(scene_, frame)},
                {"bounds", std::move(bounds)}},
               out_);
  }

  void totals(std::span<const Bounded> bounded, const FrameCosts& costs) {
    ordered_json bounds = ordered_json::array();
    for (const Bounded& b : bounded) bounds.emplace_back(named(b))["box"] = box_json(b.all_frames);
    write_line({{"totals", {{"frames", costs.seconds.size()}, {"bounds", std::move(bounds)}}},
                {"counters", counters_json(costs.work)}},
               out_);
  }

 private:
  ordered_json named(const Bounded& bounded) const {
    const Collider& collider = colliders_[bounded.collider];
    ordered_json entry = {{"index", bounded.collider}};
    const std::uint32_t character = scene_.instances[collider.instance].character;
    if (bounded.joint)
      entry["joint"] = joint_name(scene_.characters[character].asset, *bounded.joint);
    return entry;
  }

  static ordered_json box_json(const Box& box) {
    return {{"low", vector_json(box.low)}, {"high", vector_json(box.high)}};
  }

  const scenes::Scene& scene_;
  std::span<const Collider> colliders_;
  std::ostream& out_;
};

std::string name_of(const scenes::Scene& scene, const Collider& collider, const Bounded& bounded) {
  const std::string name = collider_name(scene, collider);
  if (!bounded.joint) return name;
  const std::uint32_t character = scene.instances[collider.instance].character;
  return name + " " + joint_name(scene.characters[character].asset, *bounded.joint);
}

void print_boxes(const scenes::Scene& scene, std::span<const Collider> colliders,
                 std::span<const Bounded> bounded, std::ostream& out) {
  std::vector<std::string> names;
  std::size_t width = 0;
  for (const Bounded& b : bounded) {
    names.push_back(name_of(scene, colliders[b.collider], b));
    width = std::max(width, names.back().size());
  }
  out << "\nleast and greatest x, y, z of all frames"
      << (bounded.empty() || !bounded[0].sphere ? "" : "; largest radius") << '\n';
  for (std::size_t i = 0; i < bounded.size(); ++i) {
    const Bounded& b = bounded[i];
    out << "  " << std::left << std::setw(static_cast<int>(width)) << names[i] << "  "
        << coordinates(b.all_frames.low) << "  " << coordinates(b.all_frames.high);
    if (b.sphere) out << "  " << fixed(static_cast<double>(b.largest_radius), 3);
    out << '\n';
  }
  out << '\n';
}

void print_summary(const scenes::Scene& scene, std::span<const Collider> colliders,
                   const BoundsSettings& settings, std::span<const Bounded> bounded,
                   const FrameCosts& costs, std::ostream& out) {
  print_scene(scene, colliders, out);
  label(out, "bounds") << (settings.kind == BoundsKind::exact ? "exact" : "guaranteed") << ", in "
                       << counted(costs.seconds.size(), "frame") << '\n';
  print_boxes(scene, colliders, bounded, out);
  print_costs(costs.seconds, costs.work, out);
}

}  // namespace

Result<void> bounds_scene(const scenes::Scene& scene, const BoundsSettings& settings,
                          const ModelArguments& models, const std::string& jsonl,
                          std::ostream& words) {
  const auto granularity =
      settings.by == BoundsBy::part ? Granularity::part : Granularity::instance;
  const auto colliders = make_colliders(scene, granularity, models);
  if (!colliders) return colliders.error();
  LineOutput lines;
  if (const auto opened = lines.open(jsonl); !opened) return opened.error();
  std::optional<BoundsWriter> writer;
  if (lines.stream() != nullptr) writer.emplace(scene, *colliders, *lines.stream());
  if (writer) writer->header(settings);
  BoundsQuery query(*colliders, settings);
  const auto record = [&](std::uint32_t frame) {
    query.unite();
    if (writer) writer->frame(frame, query.bounded());
  };
  const Result<FrameCosts> costs =
      run_frames(scene, *colliders, settings.frames,
                 {[&](std::span<Pose> poses) { return query.ask(poses); }, record});
  if (!costs) return asset::prefixed(scene.name, costs.error());
  if (writer) writer->totals(query.bounded(), *costs);
  if (const auto closed = lines.close(); !closed) return closed.error();
  print_summary(scene, *colliders, settings, query.bounded(), *costs, words);
  return {};
}

}  // namespace pelt::tools
