/// `pelt region`: the characters in a region of space, frame by frame.

#include <pelt/solid.hpp>

#include "tools/pelt/arguments/region_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/query/frame_query.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/query_arguments.hpp"
#include "tools/pelt/scene/summary_lines.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iomanip>
#include <vector>

namespace pelt::tools::verbs {
namespace {

using nlohmann::ordered_json;

struct RegionSettings {
  arguments::ChosenRegion region;
  scene::Granularity granularity = scene::Granularity::instance;
  bool finds_triangles = false;
};

/// Placement of a collider in the current frame, and number of frames per placement.
struct Placed {
  Placement placement = Placement::outside;
  TrianglesInRegion triangles;
  std::array<std::uint32_t, 3> frames = {};       ///< by placement
  std::vector<std::uint32_t> frames_not_outside;  ///< frame numbers
};

ordered_json whole_model_numbers(const scene::Collider& collider,
                                 std::span<const std::uint32_t> triangles) {
  ordered_json numbers = ordered_json::array();
  for (const std::uint32_t t : triangles) numbers.push_back(collider.number_in_asset(t));
  return numbers;
}

class RegionQuery final : public query::FrameQuery {
 public:
  RegionQuery(const scene::StagedScene& staged, RegionSettings settings)
      : staged_(staged), settings_(std::move(settings)), placed_(staged.colliders.size()) {}

  QueryStats ask(std::span<Pose> poses) override {
    QueryStats work;
    const Region region = settings_.region.region();
    for (std::size_t c = 0; c < poses.size(); ++c) {
      work += classify(poses[c], region, scratch_, placed_[c].placement);
      if (!settings_.finds_triangles) continue;
      TrianglesInRegion& triangles = placed_[c].triangles;
      triangles.intersecting.clear();
      triangles.inside.clear();
      work += find_triangles(poses[c], region, scratch_, triangles);
    }
    return work;
  }

  void keep(std::uint32_t frame) override {
    for (Placed& placed : placed_) {
      ++placed.frames[static_cast<std::size_t>(placed.placement)];
      if (placed.placement != Placement::outside) placed.frames_not_outside.push_back(frame);
    }
  }

  const char* format() const override { return "pelt-region"; }

  ordered_json options_json() const override {
    ordered_json options = {{settings_.region.kind(), settings_.region.numbers()}};
    if (const auto& view = settings_.region.view()) {
      options["angle"] = view->degrees;
      options["aspect"] = view->aspect;
    }
    options["by"] = settings_.granularity == scene::Granularity::part ? "part" : "instance";
    options["triangles"] = settings_.finds_triangles;
    return options;
  }

  void write_frame(scene::JsonLine& line) const override {
    line.begin_list("placements");
    for (std::size_t c = 0; c < placed_.size(); ++c) {
      ordered_json entry = {{"index", c}, {"placement", name_of(placed_[c].placement)}};
      if (settings_.finds_triangles) {
        const TrianglesInRegion& triangles = placed_[c].triangles;
        entry["intersecting"] = whole_model_numbers(staged_.colliders[c], triangles.intersecting);
        entry["inside"] = whole_model_numbers(staged_.colliders[c], triangles.inside);
      }
      line.item(entry);
    }
    line.end_list();
  }

  void write_totals(scene::JsonLine& line) const override {
    line.begin_list("placements");
    for (std::size_t c = 0; c < placed_.size(); ++c) {
      ordered_json entry = {{"index", c}};
      for (const Placement p : {Placement::outside, Placement::partly, Placement::inside})
        entry[name_of(p)] = placed_[c].frames[static_cast<std::size_t>(p)];
      line.item(entry);
    }
    line.end_list();
  }

  void print(const arguments::FrameRange& frames, std::ostream& out) const override {
    std::vector<std::string> names;
    std::size_t width = 0;
    for (const scene::Collider& collider : staged_.colliders) {
      names.push_back(scene::collider_name(staged_, collider));
      width = std::max(width, names.back().size());
    }
    const auto column = [&](auto text) -> std::ostream& { return out << std::setw(9) << text; };
    out << "\nframes\n  " << std::string(width, ' ') << std::right;
    for (const Placement p : {Placement::outside, Placement::partly, Placement::inside})
      column(name_of(p));
    out << '\n';
    for (std::size_t c = 0; c < placed_.size(); ++c) {
      out << "  " << std::left << std::setw(static_cast<int>(width)) << names[c] << std::right;
      for (const std::uint32_t count : placed_[c].frames) column(count);
      if (!placed_[c].frames_not_outside.empty())
        out << "  not outside in "
            << scene::frame_runs(staged_.scene, placed_[c].frames_not_outside, frames.stride);
      out << '\n';
    }
    out << '\n';
  }

 private:
  scene::StagedScene staged_;
  RegionSettings settings_;
  Scratch scratch_;
  std::vector<Placed> placed_;
};

struct Arguments {
  scene::QueryArguments query;
  arguments::RegionArguments region;
  std::string by = "instance";
  bool triangles = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt region scene.json --camera 0,1,4,0,1,0 --angle 40
  pelt region scene.json --sphere 0,0.5,0,0.3 --frames 20:21 --triangles --jsonl -
  pelt region knight.glb --clip Walk --box -1,0,-1,1,2,1 --by part
  pelt region scene.json --capsule 0,0,0,0,1,0,0.2

Outside: no triangle touches the region. Inside: all triangles lie wholly in the region. Otherwise:
partly. The answer is exact. Region and triangles are closed sets, so touching counts.)";

Result<arguments::ExitCode> run(const Arguments& arguments) {
  Result<arguments::ChosenRegion> region = arguments::choose_region(arguments.region);
  if (!region) return region.error();
  const Result<scene::Granularity> granularity = scene::choose_granularity(arguments.by);
  if (!granularity) return granularity.error();
  return query::run<RegionQuery>(
      arguments.query, *granularity,
      RegionSettings{std::move(*region), *granularity, arguments.triangles});
}

}  // namespace

void add_region(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(
      app, "region",
      "Find which characters are in a box, a ball, a capsule or the view of a camera", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  scene::add_query_options(verb, arguments->query);
  arguments::add_region_options(verb, arguments->region);
  verb.option("--by", arguments->by, "What is tested: each instance, or each part",
              {.type = "instance|part"});
  verb.flag("--triangles", arguments->triangles,
            "Also write the triangles that touch the region and those inside");
  verb.runs([arguments] { return run(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs
