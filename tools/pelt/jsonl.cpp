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
      {"clearance", nullptr}};
  if (options.clearance) shown["clearance"] = *options.clearance;
  if (options.max_contacts) shown["max_contacts"] = *options.max_contacts;
  ordered_json header = header_json("pelt-check", scene_, colliders_);
  header["options"] = std::move(shown);
  write_line(header, out_);
}

void JsonlWriter::frame(std::uint32_t frame, double time, const FrameContacts& found,
                        const ContactDetails* details) {
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
  write_line({{"frame", frame},
              {"time", time},
              {"contacts", found.contacts.size()},
              {"pairs", std::move(pairs)}},
             out_);
}

void JsonlWriter::totals(const CheckTotals& totals) {
  ordered_json last = {{"totals",
                        {{"frames", totals.frames},
                         {"frames_in_contact", totals.frames_in_contact},
                         {"contacts", totals.contacts}}},
                       {"counters", counters_json(totals.work)},
                       {"hash", nullptr}};
  if (totals.hash) {
    last["hash"] = hex16(*totals.hash);
  } else {
    last["cut_short"] = true;
  }
  write_line(last, out_);
}

}  // namespace pelt::tools
