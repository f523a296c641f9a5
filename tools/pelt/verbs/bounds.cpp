/// `pelt bounds`: the size of posed characters, frame by frame.

#include <pelt/bounds.hpp>

#include "scenes/names.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/query/frame_query.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace pelt::tools::verbs {
namespace {

using nlohmann::ordered_json;

enum class BoundsBy { instance, part, joint };

enum class BoundsKind {
  guaranteed,  ///< computed without posing vertices
  exact,       ///< the smallest box
};

struct BoundsSettings {
  BoundsBy by = BoundsBy::instance;
  BoundsKind kind = BoundsKind::guaranteed;
};

/// The box of nothing.
constexpr Box empty_box() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

/// Something with bounds: a collider, or the vertices of one of its joints.
struct Bounded {
  std::uint32_t collider = 0;
  std::optional<std::uint32_t> joint = std::nullopt;
  Box box = {};
  std::optional<Sphere> sphere = std::nullopt;  ///< joints have none
  Box all_frames = empty_box();
  float largest_radius = 0;
};

Box united(const Box& a, const Box& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

ordered_json box_json(const Box& box) {
  return {{"low", scene::vector_json(box.low)}, {"high", scene::vector_json(box.high)}};
}

class BoundsQuery final : public query::FrameQuery {
 public:
  BoundsQuery(const scene::StagedScene& staged, const BoundsSettings& settings)
      : staged_(staged), settings_(settings) {
    const std::span<const scene::Collider> colliders = staged.colliders;
    for (std::uint32_t c = 0; c < colliders.size(); ++c) {
      if (settings.by == BoundsBy::joint) {
        add_joints(c, colliders[c].model);
      } else {
        bounded_.push_back({.collider = c});
      }
    }
  }

  QueryStats ask(std::span<Pose> poses) override {
    QueryStats work;
    for (Bounded& bounded : bounded_) {
      Pose& pose = poses[bounded.collider];
      if (bounded.joint) {
        work += find_joint_box(pose, groups_[bounded.collider], *bounded.joint, bounded.box);
      } else {
        Bounds found;
        work += settings_.kind == BoundsKind::exact ? exact_bounds(pose, found)
                                                    : pelt::bounds(pose, found);
        bounded.box = found.box;
        bounded.sphere = found.sphere;
      }
    }
    return work;
  }

  void keep(std::uint32_t) override {
    for (Bounded& bounded : bounded_) {
      bounded.all_frames = united(bounded.all_frames, bounded.box);
      if (bounded.sphere)
        bounded.largest_radius = std::max(bounded.largest_radius, bounded.sphere->radius);
    }
  }

  const char* format() const override { return "pelt-bounds"; }

  ordered_json options_json() const override {
    constexpr const char* kNames[] = {"instance", "part", "joint"};
    return {{"by", kNames[static_cast<int>(settings_.by)]},
            {"exact", settings_.kind == BoundsKind::exact}};
  }

  void write_frame(scene::JsonLine& line) const override {
    line.begin_list("bounds");
    for (const Bounded& b : bounded_) {
      ordered_json entry = named_json(b);
      entry["box"] = box_json(b.box);
      if (b.sphere)
        entry["sphere"] = {{"centre", scene::vector_json(b.sphere->centre)},
                           {"radius", b.sphere->radius}};
      line.item(entry);
    }
    line.end_list();
  }

  void write_totals(scene::JsonLine& line) const override {
    line.begin_list("bounds");
    for (const Bounded& b : bounded_) {
      ordered_json entry = named_json(b);
      entry["box"] = box_json(b.all_frames);
      line.item(entry);
    }
    line.end_list();
  }

  void print(const arguments::FrameRange& frames, std::ostream& words) const override {
    scene::label(words, "bounds") << (settings_.kind == BoundsKind::exact ? "exact" : "guaranteed")
                                  << ", in " << text::counted(frames.frames().size(), "frame")
                                  << '\n';
    print_boxes(words);
  }

 private:
  void add_joints(std::uint32_t collider, const SkinnedModel& model) {
    groups_.push_back(group_by_joint(model));
    for (std::uint32_t j = 0; j < groups_.back().count(); ++j) {
      if (groups_.back().vertex_count(j) > 0)
        bounded_.push_back({.collider = collider, .joint = j});
    }
  }

  QueryStats find_joint_box(const Pose& pose, const VertexGroups& groups, std::uint32_t joint,
                            Box& box) const {
    return settings_.kind == BoundsKind::exact ? exact_group_bounds(pose, groups, joint, box)
                                               : group_bounds(pose, groups, joint, box);
  }

  std::string joint_of(const Bounded& bounded) const {
    return scenes::joint_name(staged_.asset_of(bounded.collider), *bounded.joint);
  }

  std::string name_of(const Bounded& bounded) const {
    const std::string name = scene::collider_name(staged_, staged_.colliders[bounded.collider]);
    return bounded.joint ? name + " " + text::printable_name(joint_of(bounded)) : name;
  }

  ordered_json named_json(const Bounded& bounded) const {
    ordered_json entry = {{"index", bounded.collider}};
    if (bounded.joint) entry["joint"] = joint_of(bounded);
    return entry;
  }

  void print_boxes(std::ostream& out) const {
    std::vector<std::string> names;
    std::size_t width = 0;
    for (const Bounded& b : bounded_) {
      names.push_back(name_of(b));
      width = std::max(width, names.back().size());
    }
    out << "\nminimum and maximum x, y, z over all frames"
        << (bounded_.empty() || !bounded_[0].sphere ? "" : "; largest radius") << '\n';
    for (std::size_t i = 0; i < bounded_.size(); ++i) {
      const Bounded& b = bounded_[i];
      out << "  " << std::left << std::setw(static_cast<int>(width)) << names[i] << "  "
          << scene::coordinates(b.all_frames.low) << "  " << scene::coordinates(b.all_frames.high);
      if (b.sphere) out << "  " << text::fixed(static_cast<double>(b.largest_radius), 3);
      out << '\n';
    }
    out << '\n';
  }

  scene::StagedScene staged_;
  BoundsSettings settings_;
  std::vector<VertexGroups> groups_;  // of each collider, by joint only
  std::vector<Bounded> bounded_;
};

struct Arguments {
  scene::QueryArguments query;
  std::string by = "instance";
  bool exact = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt bounds scene.json
  pelt bounds scene.json --frames 20:21 --exact --by part
  pelt bounds knight.glb --clip Walk --by joint --jsonl -
  pelt bounds knight.glb --clip Attack --exact --jsonl bounds.jsonl

Boxes and spheres are guaranteed to enclose every triangle. Without --exact, they are computed from
the joint matrices and the morph weights, without skinning. For a human in motion, a box is then a
few per cent to 25 % larger than the exact box. With --by joint, a box encloses the vertices for which
the joint has the largest weight.)";

Result<BoundsBy> choose_by(const std::string& name) {
  if (name == "instance") return BoundsBy::instance;
  if (name == "part") return BoundsBy::part;
  if (name == "joint") return BoundsBy::joint;
  return text::bad_argument("--by", "unknown value " + text::quoted(name),
                            "give instance, part or joint");
}

Result<arguments::ExitCode> run(const Arguments& arguments) {
  const Result<BoundsBy> by = choose_by(arguments.by);
  if (!by) return by.error();
  const BoundsSettings settings = {*by,
                                   arguments.exact ? BoundsKind::exact : BoundsKind::guaranteed};
  return query::run<BoundsQuery>(
      arguments.query,
      *by == BoundsBy::part ? scene::Granularity::part : scene::Granularity::instance, settings);
}

}  // namespace

void add_bounds(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "bounds",
                       "Compute boxes and spheres around the characters in every frame", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  scene::add_query_options(verb, arguments->query);
  verb.flag(
      "--exact", arguments->exact,
      "Compute the smallest box around the posed vertices that triangles use, exact to the bit");
  verb.option("--by", arguments->by, "What gets bounds: each instance, each part, or each joint",
              {.type = "instance|part|joint"});
  verb.runs([arguments] { return run(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
