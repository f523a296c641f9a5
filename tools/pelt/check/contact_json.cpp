#include "tools/pelt/check/contact_json.hpp"

#include "scenes/names.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

const char* name_of(ContactKind kind) {
  constexpr const char* kNames[] = {"segment", "point", "coplanar", "collapsed"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// Describes one of the two bodies.
class Side {
 public:
  Side(const scene::StagedScene& staged, std::uint32_t collider)
      : collider_(staged.colliders[collider]),
        character_(staged.character_of(collider)),
        asset_(staged.asset_of(collider)),
        names_(*staged.names) {}

  std::string joint(std::uint16_t joint) const { return scenes::joint_name(asset_, joint); }

  /// `own` is numbered as in the collider's own model.
  std::uint32_t triangle(std::uint32_t own) const { return collider_.number_in_asset(own); }

  std::uint32_t part_of(std::uint32_t own) const {
    return static_cast<std::uint32_t>(&asset_.part_of(triangle(own)) - asset_.parts.data());
  }

  const std::string& part(std::uint32_t part) const { return names_.part(character_, part); }

 private:
  const scene::Collider& collider_;
  std::uint32_t character_;
  const asset::Asset& asset_;
  const scene::SceneNames& names_;
};

ordered_json trace_json(const Side& a, const Side& b, const ContactTrace& trace) {
  return {
      {"triangles", {a.triangle(trace.contact.triangle_a), b.triangle(trace.contact.triangle_b)}},
      {"kind", name_of(trace.kind)},
      {"from", scene::vector_json(trace.from)},
      {"to", scene::vector_json(trace.to)},
      {"normal", scene::vector_json(trace.normal)},
      {"depth", trace.depth},
      {"joints", {a.joint(trace.joint_a), b.joint(trace.joint_b)}}};
}

ordered_json curve_json(const ContactGeometry& geometry, const ContactCurve& curve) {
  ordered_json traces = ordered_json::array(), points = ordered_json::array();
  const auto steps = std::span(geometry.steps).subspan(curve.first, curve.count);
  const auto end_of = [&](const CurveStep& step, bool is_last) {
    const ContactTrace& trace = geometry.traces[step.trace];
    return scene::vector_json(step.is_reversed == is_last ? trace.from : trace.to);
  };
  for (const CurveStep& step : steps) {
    traces.push_back(step.trace);
    points.push_back(end_of(step, false));
  }
  points.push_back(end_of(steps.back(), true));
  return {
      {"closed", curve.is_closed}, {"traces", std::move(traces)}, {"points", std::move(points)}};
}

/// The part with the most members of a region; among equal ones the first.
template <typename TriangleOf>
std::string part_of_most(const Side& side, std::span<const std::uint32_t> members,
                         const TriangleOf& triangle_of) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const std::uint32_t member : members) ++counts[side.part_of(triangle_of(member))];
  const auto fewer = [](const auto& x, const auto& y) { return x.second < y.second; };
  return side.part(std::max_element(counts.begin(), counts.end(), fewer)->first);
}

ordered_json patch_json(const Side& a, const Side& b, const ContactGeometry& geometry,
                        const ContactPatch& patch) {
  const auto members = std::span(geometry.members).subspan(patch.first, patch.count);
  const auto contact_of = [&](std::uint32_t m) { return geometry.traces[m].contact; };
  return {{"traces", members},
          {"length", patch.length},
          {"point", scene::vector_json(patch.point)},
          {"normal", scene::vector_json(patch.normal)},
          {"depth", patch.depth},
          {"joints", {a.joint(patch.joint_a), b.joint(patch.joint_b)}},
          {"parts",
           {part_of_most(a, members, [&](std::uint32_t m) { return contact_of(m).triangle_a; }),
            part_of_most(b, members, [&](std::uint32_t m) { return contact_of(m).triangle_b; })}}};
}

}  // namespace

ordered_json contact_geometry_json(const scene::StagedScene& staged, std::uint32_t a,
                                   std::uint32_t b, const ContactGeometry& geometry) {
  const Side side_a(staged, a), side_b(staged, b);
  ordered_json traces = ordered_json::array(), curves = traces, patches = traces;
  for (const ContactTrace& trace : geometry.traces)
    traces.push_back(trace_json(side_a, side_b, trace));
  for (const ContactCurve& curve : geometry.curves) curves.push_back(curve_json(geometry, curve));
  for (const ContactPatch& patch : geometry.patches)
    patches.push_back(patch_json(side_a, side_b, geometry, patch));
  return {{"traces", std::move(traces)},
          {"curves", std::move(curves)},
          {"patches", std::move(patches)}};
}

}  // namespace pelt::tools::check
