#include "tools/pelt/page/verdict_html.hpp"

#include "tools/pelt/output/text.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace pelt::tools::page {
namespace {

using nlohmann::ordered_json;

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text)
    if (c == '<')
      html += "&lt;";
    else if (c == '&')
      html += "&amp;";
    else
      html += c;
  return html;
}

std::string number(const ordered_json& value) {
  return output::with_commas(value.get<std::uint64_t>());
}

const char* headline(const ordered_json& verdict) {
  if (verdict["fail_on"] == "never") return "Report";
  return verdict["failed"] == true ? "Check failed" : "Check passed";
}

/// Says what counts as a contact.
std::string clearance_words(const ordered_json& options) {
  const ordered_json& distance = options["clearance"];
  return distance.is_null() ? "" : " (triangles at most " + distance.dump() + " apart)";
}

std::string limit_words(const ordered_json& options) {
  const ordered_json& limit = options["max_contacts"];
  return limit.is_null() ? "" : ", at most " + number(limit) + " of each pair in each frame";
}

/// Says what was tested against itself.
const char* self_sentence(const ordered_json& options) {
  if (options["self"].is_null()) return "";
  if (options["self"]["only"] == true) return " Only contacts of characters with themselves count.";
  return " Contacts of characters with themselves count, too.";
}

/// Says what touches between frames only, with --between.
std::string between_sentence(const ordered_json& totals) {
  if (!totals.contains("between")) return "";
  const ordered_json& between = totals["between"];
  return " Between frames only: " + number(between["contacts"]) + " contacts in " +
         number(between["steps_in_contact"]) + " of " + number(between["steps"]) + " steps.";
}

/// Says in how many frames contacts may be missing, with --budget.
std::string unknown_sentence(const ordered_json& totals) {
  if (!totals.contains("unknown") || totals["unknown"]["frames"] == 0) return "";
  return " The budget did not suffice: more contacts are possible in " +
         number(totals["unknown"]["frames"]) + " frames.";
}

}  // namespace

std::string verdict_html(const PageData& data) {
  if (!data.answer) return "";
  std::istringstream lines(data.answer->lines);
  ordered_json first, last;
  lines >> first >> last;
  const ordered_json& totals = last["totals"];
  return std::string(headline(last["verdict"])) + ": " + number(totals["frames_in_contact"]) +
         " of " + number(totals["frames"]) + " frames in contact, " + number(totals["contacts"]) +
         " contacts" + clearance_words(first["options"]) + limit_words(first["options"]) + "." +
         self_sentence(first["options"]) + between_sentence(totals) + unknown_sentence(totals) +
         " Command: <code>" + escaped(data.command) + "</code>";
}

}  // namespace pelt::tools::page
