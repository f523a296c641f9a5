#include "tools/pelt/jsonl.hpp"

#include "tools/pelt/contact_json.hpp"
#include "tools/pelt/json_lines.hpp"
#include "tools/pelt/text.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools {
namespace {

using nlohmann::ordered_json;

ordered_json triangles_json(std::span<const Contact> contacts) {
  ordered_json triangles = ordered_json::array();
  for (const Contact& contact : contacts) {
    triangles.push_back({contact.triangle_a, contact.triangle_b});
  }
  return triangles;
}

ordered_json verdict_json(const scenes::Scene& scene, const Verdict& verdict) {
  ordered_json json = {
      {"fail_on", name_of(verdict.fail_on)}, {"failed", verdict.is_failed}, {"worse", nullptr}};
  if (!verdict.has_baseline) return json;
  json["worse"] = ordered_json::array();
  for (const Worse& worse : verdict.worse) {
    json["worse"].push_back(touch_json(scene, worse.touch));
    json["worse"].back()["known"] = worse.known;
  }
  return json;
}

}  // namespace

void JsonlWriter::header(const CheckOptionsShown& options) {
  ordered_json shown = {
      {"method", options.method},
      {"by", options.by},
      {"frames", {options.frames.begin, options.frames.end, options.frames.stride}},
      {"fps", scene_.fps},
      {"max_contacts", nullptr},
      {"pairs", lists_ == TriangleLists::written},
      {"contacts", options.contacts},
      {"inside", options.inside},
      {"clearance", nullptr}};
  shown["ignore"] = ordered_json::array();
  for (const scenes::NamePair& pair : options.ignore) shown["ignore"].push_back({pair.a, pair.b});
  if (options.clearance) shown["clearance"] = *options.clearance;
  if (options.max_contacts) shown["max_contacts"] = *options.max_contacts;
  ordered_json header = header_json("pelt-check", scene_, colliders_);
  header["options"] = std::move(shown);
  write_line(header, out_);
}

void JsonlWriter::frame(std::uint32_t frame, double time, const FrameContacts& found,
                        const FrameExtras& extras) {
  ordered_json line = {{"frame", frame},
                       {"time", time},
                       {"contacts", found.contacts.size()},
                       {"pairs", pairs_json(found, extras.details)}};
  if (extras.inside != nullptr) line["inside"] = inside_json(*extras.inside);
  write_line(line, out_);
}

ordered_json JsonlWriter::pairs_json(const FrameContacts& found,
                                     const ContactDetails* details) const {
  ordered_json pairs = ordered_json::array();
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    const FrameContacts::Pair& pair = found.pairs[i];
    ordered_json& entry = pairs.emplace_back();
    entry["a"] = pair.a;
    entry["b"] = pair.b;
    entry["contacts"] = pair.end - pair.begin;
    if (lists_ == TriangleLists::written) entry["triangles"] = triangles_json(found.of(pair));
    if (details != nullptr) {
      entry.update(contact_geometry_json(scene_, colliders_[pair.a], colliders_[pair.b],
                                         details->of_pair(i)));
    }
  }
  return pairs;
}

ordered_json JsonlWriter::inside_json(const InsideQuery& inside) const {
  const auto deepest = [&](const Penetration& found, std::uint32_t outer) -> ordered_json {
    if (!found.found()) return nullptr;
    return {{"depth", found.depth},
            {"position", vector_json(found.position)},
            {"nearest", vector_json(found.nearest.position)},
            {"triangle", found.nearest.triangle + colliders_[outer].first_triangle}};
  };
  ordered_json pairs = ordered_json::array();
  for (const InsidePair& pair : inside.pairs()) {
    ordered_json entry = {{"a", pair.a}, {"b", pair.b}, {"held", nullptr}};
    if (pair.containment == Containment::a_in_b) entry["held"] = "a";
    if (pair.containment == Containment::b_in_a) entry["held"] = "b";
    entry["a_in_b"] = deepest(pair.a_in_b, pair.b);
    entry["b_in_a"] = deepest(pair.b_in_a, pair.a);
    pairs.push_back(std::move(entry));
  }
  return pairs;
}

void JsonlWriter::totals(const CheckTotals& totals, std::span<const Touch> touches,
                         const Verdict& verdict) {
  ordered_json last = {{"totals",
                        {{"frames", totals.frames},
                         {"frames_in_contact", totals.frames_in_contact},
                         {"contacts", totals.contacts},
                         {"ignored", totals.ignored}}},
                       {"counters", counters_json(totals.work)},
                       {"hash", nullptr}};
  if (totals.hash) {
    last["hash"] = hex16(*totals.hash);
  } else {
    last["cut_short"] = true;
  }
  last["touches"] = ordered_json::array();
  for (const Touch& touch : touches) last["touches"].push_back(touch_json(scene_, touch));
  last["verdict"] = verdict_json(scene_, verdict);
  write_line(last, out_);
}

}  // namespace pelt::tools
