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

}  // namespace

std::string verdict_html(const PageData& data) {
  if (!data.answer) return "";
  std::istringstream lines(data.answer->lines);
  ordered_json first, last;
  lines >> first >> last;
  const ordered_json& totals = last["totals"];
  return std::string(headline(last["verdict"])) + ": " + number(totals["frames_in_contact"]) +
         " of " + number(totals["frames"]) + " frames in contact, " + number(totals["contacts"]) +
         " contacts. Command: <code>" + escaped(data.command) + "</code>";
}

}  // namespace pelt::tools::page
