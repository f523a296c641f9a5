#include "tools/pelt/check/frame_line.hpp"

#include "scenes/names.hpp"
#include "text/json_text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

const char* kind_name(ContactKind kind) {
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
      {"kind", kind_name(trace.kind)},
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

/// `traces`, `curves` and `patches` as in the manual page, with names of parts and joints.
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

ordered_json triangles_json(std::span<const Contact> contacts) {
  ordered_json triangles = ordered_json::array();
  for (const Contact& contact : contacts) {
    triangles.push_back({contact.triangle_a, contact.triangle_b});
  }
  return triangles;
}

/// Writes the members of a part of an answer with their names.
class NamedMembers : public MemberWriter<NamedMembers> {
 public:
  template <typename T>
  void add(const char* name, const T& value) {
    json[name] = value;
  }
  template <typename Choice, std::size_t kCount>
  void choice(const char* name, Choice value, const char* const (&names)[kCount]) {
    json[name] = names[static_cast<std::size_t>(value)];
  }

  ordered_json json;
};

ordered_json undecided_json(std::span<const Undecided> undecided) {
  ordered_json list = ordered_json::array();
  for (const Undecided& pair : undecided) {
    NamedMembers members;
    describe(members, pair);
    list.push_back(std::move(members.json));
  }
  return list;
}

/// `geometry`: see frame_line.
ordered_json found_json(const Stage& stage, const scene::FrameContacts& found,
                        std::span<const ContactGeometry> geometry) {
  ordered_json pairs = ordered_json::array();
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const scene::FrameContacts::Pair& pair = found.pairs[i];
    ordered_json& entry = pairs.emplace_back();
    entry["a"] = pair.a;
    entry["b"] = pair.b;
    entry["contacts"] = pair.end - pair.begin;
    if (stage.settings.options.pairs) entry["triangles"] = triangles_json(found.of(pair));
    if (!geometry.empty())
      entry.update(contact_geometry_json(stage.staged, pair.a, pair.b, geometry[i]));
  }
  return pairs;
}

ordered_json inside_json(const scene::StagedScene& staged, std::span<const InsidePair> inside) {
  const auto deepest = [&](const Penetration& found, std::uint32_t outer) -> ordered_json {
    if (!found) return nullptr;
    return {{"depth", found.depth},
            {"position", scene::vector_json(found.position)},
            {"closest", scene::vector_json(found.closest.position)},
            {"triangle", staged.colliders[outer].number_in_asset(found.closest.triangle)}};
  };
  ordered_json pairs = ordered_json::array();
  for (const InsidePair& pair : inside) {
    ordered_json entry = {{"a", pair.a}, {"b", pair.b}, {"held", nullptr}};
    if (pair.containment == Containment::a_in_b) entry["held"] = "a";
    if (pair.containment == Containment::b_in_a) entry["held"] = "b";
    entry["a_in_b"] = deepest(pair.a_in_b, pair.b);
    entry["b_in_a"] = deepest(pair.b_in_a, pair.a);
    pairs.push_back(std::move(entry));
  }
  return pairs;
}

}  // namespace

nlohmann::ordered_json left_out_json(const LeftOut& left_out) {
  return {{"rings", left_out.rings},
          {"at_rest", left_out.at_rest},
          {"always", left_out.always},
          {"near_joints", left_out.joints}};
}

std::string frame_line(const Stage& stage, const FrameAnswer& answer,
                       std::span<const ContactGeometry> geometry) {
  ordered_json line = scene::frame_json(stage.staged.scene, answer.frame);
  line["contacts"] = answer.found.contacts.size();
  line["pairs"] = found_json(stage, answer.found, geometry);
  if (stage.settings.options.budget) line["unknown"] = undecided_json(answer.undecided);
  if (stage.settings.self.asks_self()) line["left_out"] = left_out_json(answer.left_out);
  if (stage.settings.options.inside) line["inside"] = inside_json(stage.staged, answer.inside);
  return text::json_text(line);
}

}  // namespace pelt::tools::check
