#include "tools/pelt/check/frame_line.hpp"

#include "tools/pelt/check/contact_json.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

ordered_json triangles_json(std::span<const Contact> contacts) {
  ordered_json triangles = ordered_json::array();
  for (const Contact& contact : contacts) {
    triangles.push_back({contact.triangle_a, contact.triangle_b});
  }
  return triangles;
}

ordered_json undecided_json(std::span<const Undecided> undecided) {
  ordered_json list = ordered_json::array();
  for (const Undecided& pair : undecided)
    list.push_back({{"a", pair.a},
                    {"b", pair.b},
                    {"verdict", pair.verdict == pelt::Verdict::touching ? "touching" : "unknown"},
                    {"pairs", pair.pairs},
                    {"resolution", pair.resolution},
                    {"distance_bound", pair.distance_bound}});
  return list;
}

/// `details`: see frame_line.
ordered_json found_json(const scene::StagedScene& staged, const scene::FrameContacts& found,
                        bool lists_triangles, const ContactDetails* details) {
  ordered_json pairs = ordered_json::array();
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const scene::FrameContacts::Pair& pair = found.pairs[i];
    ordered_json& entry = pairs.emplace_back();
    entry["a"] = pair.a;
    entry["b"] = pair.b;
    entry["contacts"] = pair.end - pair.begin;
    if (lists_triangles) entry["triangles"] = triangles_json(found.of(pair));
    if (details != nullptr) {
      entry.update(contact_geometry_json(staged, pair.a, pair.b, details->of_pair(i)));
    }
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

std::string frame_line(const scene::StagedScene& staged, const CheckQuestion& question,
                       const FrameAnswer& answer, const ContactDetails* details) {
  ordered_json line = scene::frame_json(staged.scene, answer.frame);
  line["contacts"] = answer.found.contacts.size();
  line["pairs"] = found_json(staged, answer.found, question.pairs, details);
  if (question.budget) line["unknown"] = undecided_json(answer.undecided);
  if (question.self.asks_self()) line["left_out"] = left_out_json(answer.left_out);
  if (question.inside) line["inside"] = inside_json(staged, answer.inside);
  return output::json_text(line);
}

ordered_json left_out_json(const LeftOut& left_out) {
  return {{"rings", left_out.rings},
          {"at_rest", left_out.at_rest},
          {"always", left_out.always},
          {"near_joints", left_out.joints}};
}

}  // namespace pelt::tools::check
