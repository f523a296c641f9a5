#include "tools/reproduce/html.hpp"

#include "tools/reproduce/base64.hpp"

namespace pelt::reproduce {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Pelt: Kavan &amp; Zara 2005 reproduced</title>
<style>
  body { font: 16px/1.5 system-ui, sans-serif; color: #1d1f23; max-width: 62rem; margin: 2rem auto;
         padding: 0 1rem }
  h1, h2 { line-height: 1.2 }
  h2 { margin-top: 3rem; border-top: 1px solid #ccd; padding-top: 1rem }
  table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem }
  caption { text-align: left; font-weight: 600; padding: .5rem 0 }
  th, td { padding: .2rem .7rem; text-align: right; border-bottom: 1px solid #e4e6ec }
  th { vertical-align: bottom; font-weight: 600; background: #f5f6f9 }
  td.name, th.name { text-align: left }
  .wide { overflow-x: auto; margin: 1rem 0 }
  figure { margin: 1rem 0 }
  figure img { max-width: 100%; height: auto; border: 1px solid #e4e6ec }
  figcaption, .note, .provenance { color: #555a66; font-size: .9rem }
</style>
</head>
<body>
<h1>Kavan &amp; Zara 2005, reproduced</h1>
<p>Every table and figure of <i>Fast Collision Detection for Skeletally Deformable Models</i> again, on
generated characters of the paper's sizes, and the comparison that it left open; real characters where
there are some. Times are those of this machine; the paper's are of a 2.5&nbsp;GHz Athlon, so only
ratios compare.</p>
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string element(const char* name, const std::string& text, const char* attributes = "") {
  return "<" + std::string(name) + attributes + ">" + escaped(text) + "</" + name + ">\n";
}

bool is_name(const Cell& cell) { return !cell.name.empty(); }

std::string html_row(const std::vector<Cell>& cells) {
  std::string row = "<tr>";
  for (const Cell& cell : cells)
    row += (is_name(cell) ? "<td class=\"name\">" : "<td>") + escaped(shown(cell)) + "</td>";
  return row + "</tr>\n";
}

std::string html_table(const Table& table) {
  std::string html = "<div class=\"wide\"><table id=\"" + table.id + "\">\n" +
                     element("caption", table.title) + "<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool holds_names = !table.rows.empty() && is_name(table.rows[0][c]);
    html += element("th", table.columns[c].title, holds_names ? " class=\"name\"" : "");
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : table.rows) html += html_row(row);
  html += "</tbody></table></div>\n";
  if (!table.note.empty()) html += element("p", table.note, " class=\"note\"");
  return html;
}

std::string html_figure(const std::string& id, const char* type, const std::string& caption,
                        const std::map<std::string, std::string>& images) {
  const auto image = images.find(id);
  if (image == images.end()) return element("p", "(not drawn: " + caption + ")", " class=\"note\"");
  return "<figure id=\"" + id + "\"><img alt=\"" + escaped(caption) + "\" src=\"data:" + type +
         ";base64," + base64(image->second) + "\">" + element("figcaption", caption) +
         "</figure>\n";
}

std::string html_section(const Section& section, const std::map<std::string, std::string>& images) {
  std::string html = "<h2 id=\"" + section.id + "\">" + escaped(section.title) + "</h2>\n";
  for (const std::string& paragraph : section.text) html += element("p", paragraph);
  for (const Picture& picture : section.pictures)
    html += html_figure(picture.id, "image/png", picture.caption, images);
  for (const Table& table : section.tables) html += html_table(table);
  for (const Chart& chart : section.charts)
    html += html_figure(chart.id, "image/svg+xml", chart.title, images);
  return html;
}

}  // namespace

std::string html_page(const std::vector<Section>& sections,
                      const std::vector<std::string>& provenance,
                      const std::map<std::string, std::string>& images) {
  std::string html = kHead;
  for (const std::string& line : provenance) html += element("p", line, " class=\"provenance\"");
  html += "<ol>\n";
  for (const Section& section : sections)
    html += "<li><a href=\"#" + section.id + "\">" + escaped(section.title) + "</a></li>\n";
  html += "</ol>\n";
  for (const Section& section : sections) html += html_section(section, images);
  return html + "</body>\n</html>\n";
}

}  // namespace pelt::reproduce
