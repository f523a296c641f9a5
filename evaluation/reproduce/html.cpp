#include "evaluation/reproduce/html.hpp"

#include "text/format.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::reproduce {
namespace {

constexpr int kSignificant = 3;
constexpr int kMaxDecimals = 6;

/// Number of digits before the decimal point, minus one, of the figure rounded to three digits: 0
/// for 1 to 9.99.
int magnitude(double figure) { return static_cast<int>(std::floor(std::log10(1.0005 * figure))); }

bool has_decimals(double figure, int decimals) {
  const double shifted = figure * std::pow(10, decimals);
  return std::fabs(shifted - std::round(shifted)) <= 1e-9 * std::max(1.0, std::fabs(shifted));
}

int decimals_of(double figure) {
  int decimals = 0;
  while (decimals < kMaxDecimals && !has_decimals(figure, decimals)) ++decimals;
  return decimals;
}

/// Decimals for three significant digits.
int significant_decimals(double figure) {
  return std::clamp(kSignificant - 1 - magnitude(figure), 0, kMaxDecimals);
}

/// "-1,234.50"
std::string with_decimals(double figure, int decimals) {
  const std::string digits = text::fixed(std::fabs(figure), decimals);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  return (figure < 0 ? "-" : "") + text::with_commas(std::stoull(digits.substr(0, point))) +
         digits.substr(point);
}

}  // namespace

ColumnFormat::ColumnFormat(std::span<const double> figures) : decimals_(0) {
  double least = HUGE_VAL, most = 0;
  int exact = 0;
  for (const double figure : figures) {
    exact = std::max(exact, decimals_of(figure));
    if (figure == 0) continue;
    least = std::min(least, std::fabs(figure));
    most = std::max(most, std::fabs(figure));
  }
  if (exact == 0) return;
  decimals_ = std::min(exact, significant_decimals(least));
  const bool is_aligned = magnitude(most) + 1 + decimals_ <= kSignificant + 1;
  if (!is_aligned) decimals_ = -1;
}

std::string ColumnFormat::shown(double figure) const {
  if (decimals_ >= 0) return with_decimals(figure, decimals_);
  return figure == 0 ? "0" : with_decimals(figure, significant_decimals(std::fabs(figure)));
}

namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Pelt: Kavan &amp; Zara 2005 reproduced</title>
<style>
  :root { color-scheme: light dark; --ink: #1d1f23; --quiet: #5a606c; --page: #fff; --band: #f4f5f8;
          --line: #dfe2e9; --link: #2f5fa8 }
  @media (prefers-color-scheme: dark) {
    :root { --ink: #e2e4e9; --quiet: #a0a6b2; --page: #17191d; --band: #22252b; --line: #363a43;
            --link: #8fb4ea }
  }
  body { font: 16px/1.55 system-ui, sans-serif; color: var(--ink); background: var(--page);
         max-width: 64rem; margin: 2rem auto 4rem; padding: 0 1rem }
  a { color: var(--link) }
  h1, h2 { line-height: 1.2 }
  h2 { margin-top: 4rem; border-top: 1px solid var(--line); padding-top: 1.2rem }
  p, li { max-width: 44rem }
  .note, .provenance, figcaption { color: var(--quiet); font-size: .875rem; max-width: 50rem;
                                   margin: .5rem 0 }
  .wide { overflow-x: auto; margin: 2rem 0 .5rem }
  table { border-collapse: separate; border-spacing: 0; font-size: .875rem; line-height: 1.4;
          font-variant-numeric: tabular-nums }
  caption { text-align: left; padding: .4rem 0 }
  caption span { position: sticky; left: 0; font-weight: 600; font-size: 1rem }
  th, td { padding: .2rem .7rem; text-align: right; white-space: nowrap;
           border-bottom: 1px solid var(--line) }
  th { vertical-align: bottom; font-weight: 600; background: var(--band); white-space: normal;
       max-width: 8.5rem }
  td.name, th.name { text-align: left }
  th:first-child, td:first-child { position: sticky; left: 0; border-right: 1px solid var(--line) }
  td:first-child { background: var(--page) }
  figure { margin: 1.5rem 0 }
  figure img { display: block; max-width: 100%; height: auto; background: #fff; border-radius: 4px;
               outline: 1px solid var(--line) }
  @media (max-width: 44rem) {
    th, td { padding: .2rem .5rem }
    td:first-child { white-space: normal; max-width: 9rem; overflow-wrap: anywhere }
  }
  @media print {
    :root { color-scheme: light; --ink: #000; --quiet: #444; --page: #fff; --band: #fff;
            --line: #bbb; --link: #000 }
    body { font-size: 10pt; margin: 0; max-width: none }
    .wide { overflow: visible }
    th, td { padding: .1rem .3rem; white-space: normal }
    th:first-child, td:first-child { position: static }
    figure, tr { break-inside: avoid }
    h2, caption { break-after: avoid }
  }
</style>
</head>
<body>
<h1>Kavan &amp; Zara 2005, reproduced</h1>
<p>Reproduces every table and figure of <i>Fast Collision Detection for Skeletally Deformable
Models</i> with generated characters of the paper's sizes and, if given, with real characters. Adds the
comparison that the paper left open. Times were measured on this machine, and the paper's on a
2.5&nbsp;GHz Athlon, so only ratios can be compared.</p>
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
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// `text` as the page shows it.
std::string typeset(const std::string& text) { return with_micro_signs(escaped(text)); }

std::string element(const char* name, const std::string& text, const char* attributes = "") {
  return "<" + std::string(name) + attributes + ">" + typeset(text) + "</" + name + ">\n";
}

bool is_name(const Cell& cell) { return !cell.name.empty(); }

std::vector<double> figures_of(const Table& table, std::size_t column) {
  std::vector<double> figures;
  for (const std::vector<Cell>& row : table.rows)
    if (row[column].figure) figures.push_back(*row[column].figure);
  return figures;
}

std::string html_head(const Table& table) {
  std::string row = "<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool holds_names = !table.rows.empty() && is_name(table.rows[0][c]);
    row += element("th", table.columns[c].title, holds_names ? " class=\"name\"" : "");
  }
  return row + "</tr></thead>\n";
}

std::string html_body(const Table& table) {
  std::vector<ColumnFormat> formats;
  for (std::size_t c = 0; c < table.columns.size(); ++c) formats.emplace_back(figures_of(table, c));
  std::string rows = "<tbody>\n";
  for (const std::vector<Cell>& row : table.rows) {
    rows += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      rows += (is_name(row[c]) ? "<td class=\"name\">" : "<td>") +
              (row[c].figure ? formats[c].shown(*row[c].figure) : typeset(row[c].name)) + "</td>";
    rows += "</tr>\n";
  }
  return rows + "</tbody>";
}

std::string html_table(const Table& table) {
  std::string html = "<div class=\"wide\"><table id=\"table-" + table.id + "\">\n<caption><span>" +
                     typeset(table.title) + "</span></caption>\n" + html_head(table) +
                     html_body(table) + "</table></div>\n";
  if (!table.note.empty()) html += element("p", table.note, " class=\"note\"");
  return html;
}

struct ImageKind {
  const char *prefix, *type;
  bool has_caption;  // charts contain their titles
};
constexpr ImageKind kChart = {"chart-", "image/svg+xml", false};
constexpr ImageKind kPicture = {"picture-", "image/png", true};

std::string html_figure(const ImageKind& kind, const std::string& id, const std::string& caption,
                        const std::map<std::string, std::string>& images) {
  const auto image = images.find(id);
  if (image == images.end()) return element("p", "(not drawn: " + caption + ")", " class=\"note\"");
  return "<figure id=\"" + (kind.prefix + id) + "\"><img alt=\"" + typeset(caption) +
         "\" src=\"data:" + kind.type + ";base64," + text::base64(image->second) + "\">" +
         (kind.has_caption ? element("figcaption", caption) : "") + "</figure>\n";
}

/// A chart follows the table that it draws.
std::string html_section(const Section& section, const std::map<std::string, std::string>& images) {
  std::string html = "<h2 id=\"" + section.id + "\">" + typeset(section.title) + "</h2>\n";
  for (const std::string& paragraph : section.text) html += element("p", paragraph);
  for (const Picture& picture : section.pictures)
    html += html_figure(kPicture, picture.id, picture.caption, images);
  for (const Table& table : section.tables) {
    html += html_table(table);
    for (const Chart& chart : section.charts)
      if (chart.table == table.id) html += html_figure(kChart, chart.id, chart.title, images);
  }
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
    html += "<li><a href=\"#" + section.id + "\">" + typeset(section.title) + "</a></li>\n";
  html += "</ol>\n";
  for (const Section& section : sections) html += html_section(section, images);
  return html + "</body>\n</html>\n";
}

}  // namespace pelt::reproduce
