#include "tools/pelt/query/region_query.hpp"

#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/scene/summary_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>

namespace pelt::tools::query {
namespace {

using nlohmann::ordered_json;

ordered_json whole_model_numbers(const scene::Collider& collider,
                                 std::span<const std::uint32_t> triangles) {
  ordered_json numbers = ordered_json::array();
  for (const std::uint32_t t : triangles) numbers.push_back(collider.number_in_asset(t));
  return numbers;
}

}  // namespace

QueryStats RegionQuery::ask(std::span<Pose> poses) {
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

void RegionQuery::keep(std::uint32_t frame) {
  for (Placed& placed : placed_) {
    ++placed.frames[static_cast<std::size_t>(placed.placement)];
    if (placed.placement != Placement::outside) placed.frames_not_outside.push_back(frame);
  }
}

ordered_json RegionQuery::options_json() const {
  ordered_json options = {{settings_.region.kind(), settings_.region.numbers()}};
  if (const auto& view = settings_.region.view()) {
    options["angle"] = view->degrees;
    options["aspect"] = view->aspect;
  }
  options["by"] = settings_.granularity == scene::Granularity::part ? "part" : "instance";
  options["triangles"] = settings_.finds_triangles;
  return options;
}

void RegionQuery::write_frame(scene::JsonLine& line) const {
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

void RegionQuery::write_totals(scene::JsonLine& line) const {
  line.begin_list("placements");
  for (std::size_t c = 0; c < placed_.size(); ++c) {
    ordered_json entry = {{"index", c}};
    for (const Placement p : {Placement::outside, Placement::partly, Placement::inside})
      entry[name_of(p)] = placed_[c].frames[static_cast<std::size_t>(p)];
    line.item(entry);
  }
  line.end_list();
}

void RegionQuery::print(std::size_t, std::ostream& out) const {
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
    for (const std::uint32_t frames : placed_[c].frames) column(frames);
    if (!placed_[c].frames_not_outside.empty())
      out << "  not outside in "
          << scene::frame_runs(staged_.scene, placed_[c].frames_not_outside, settings_.stride);
    out << '\n';
  }
  out << '\n';
}

}  // namespace pelt::tools::query
