#include "evaluation/reproduce/drawing.hpp"

#include "text/format.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string_view>

namespace pelt::reproduce {
namespace {

namespace fs = std::filesystem;

/// A drawing program and its Debian package.
struct DrawingProgram {
  const char *name, *package;
};

/// Writes `description` into a file, runs the program with `command`, which names that file, and
/// removes the file unless the program failed. The error message says what to do.
Result<void> draw(const DrawingProgram& program, std::span<const std::string> command,
                  const std::filesystem::path& file, const std::string& description) {
  const auto written = tools::output::write_file(file, std::as_bytes(std::span(description)));
  if (!written) return written.error();
  const std::string name = program.name;
  const tools::output::ProgramEnd end = tools::output::run_program(command);
  if (end == tools::output::ProgramEnd::failed)
    return Error{ErrorCode::unsupported,
                 file.string() + ": " + name + " failed: run it to see why"};
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  if (end == tools::output::ProgramEnd::succeeded) return {};
  return Error{ErrorCode::unsupported, name + " is not installed: run `apt-get install " +
                                           program.package + "`, then this again"};
}

/// Fraction of the axis' length, at both ends.
constexpr double kMargin = 0.03;

struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void include(double figure) {
    low = std::min(low, figure);
    high = std::max(high, figure);
  }
  bool is_empty() const { return low > high; }
};

std::string number(double figure) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", figure);
  return text;
}

std::string range(const std::string& axis, const Range& of) {
  return "set " + axis + "range [" + number(of.low) + ":" + number(of.high) + "]\n";
}

/// A number without an exponent: "0.05", "1,000,000".
std::string label(double figure) {
  return figure < 1 ? number(figure)
                    : text::with_commas(static_cast<std::uint64_t>(std::llround(figure)));
}

/// Whether `digit` (1 to 9) times a power of ten has a label. With fewer decades, more tics have
/// labels.
bool has_label(int digit, double decades) {
  if (digit == 1) return true;
  return decades < 1 || (decades < 2.5 && (digit == 2 || digit == 5));
}

}  // namespace

std::string linear_axis(const std::string& axis, std::span<const double> figures) {
  Range all;
  for (const double figure : figures) all.include(figure);
  if (all.is_empty()) return "";
  const double span = all.high > all.low ? all.high - all.low : 1;
  return range(axis, {all.low - kMargin * span, all.high + kMargin * span});
}

std::string axis_from(const std::string& axis, double from) {
  return "set " + axis + "range [" + number(from) + ":*]\n";
}

std::string logarithmic_axis(const std::string& axis, std::span<const double> figures) {
  Range all;
  for (const double figure : figures)
    if (figure > 0) all.include(figure);
  const std::string scale = "set logscale " + axis + "\n";
  if (all.is_empty()) return scale;
  const double decades = std::max(std::log10(all.high / all.low), 0.3);
  const double margin = std::pow(10, kMargin * decades);
  const Range shown = {all.low / margin, all.high * margin};
  std::string tics;
  for (double power = std::pow(10, std::floor(std::log10(shown.low))); power <= shown.high;
       power *= 10)
    for (int digit = 1; digit <= 9; ++digit) {
      const double at = digit * power;
      if (at < shown.low || at > shown.high) continue;
      const bool is_major = has_label(digit, decades);
      tics += (tics.empty() ? "'" : ", '") + (is_major ? label(at) : "") + "' " + number(at) +
              (is_major ? " 0" : " 1");
    }
  return scale + range(axis, shown) + "set " + axis + "tics (" + tics + ")\n";
}

namespace {

/// Inside single quotes, only these characters are special to gnuplot.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : with_micro_signs(text)) inside += c == '\'' ? "''" : std::string(1, c);
  return "'" + inside + "'";
}

std::string drawn_title(const Chart& chart) {
  switch (chart.better) {
    case Better::lower:
      return chart.title + " (lower is better)";
    case Better::higher:
      return chart.title + " (higher is better)";
    case Better::neither:
      return chart.title;
  }
  return chart.title;
}

/// The table without the rows that the chart leaves out.
Table drawn_rows(const Chart& chart, Table table) {
  const std::size_t x = column_of(table, chart.x);
  if (chart.x_end)
    std::erase_if(table.rows, [&](const std::vector<Cell>& row) {
      return row[x].figure && *row[x].figure > *chart.x_end;
    });
  return table;
}

/// The table in gnuplot's format: tabs between columns, NaN for missing figures.
std::string data_block(const Chart& chart, const Table& table) {
  std::vector<std::size_t> columns = {column_of(table, chart.x)};
  for (const std::string& key : chart.y) columns.push_back(column_of(table, key));
  std::ostringstream text;
  text.precision(10);
  for (const std::vector<Cell>& row : table.rows) {
    for (const std::size_t column : columns) {
      const std::optional<double> figure = row[column].figure;
      text << (column == columns[0] ? "" : "\t");
      figure ? text << *figure : text << "NaN";
    }
    text << '\n';
  }
  return text.str();
}

/// Dark enough on white, and distinguishable for people with red-green colour blindness. Dashes and
/// marks distinguish lines that coincide.
constexpr const char* kLines[] = {
    "'#1c6b4a' dashtype solid pointtype 7",      "'#b5533c' dashtype (12,4) pointtype 5",
    "'#2f5fa8' dashtype (3,3) pointtype 9",      "'#c28a00' dashtype (12,3,3,3) pointtype 11",
    "'#7a4fa0' dashtype (6,3) pointtype 13",     "'#333333' dashtype (12,3,3,3,3,3) pointtype 6",
    "'#4fa7b8' dashtype (18,4) pointtype 4",     "'#9aa05a' dashtype solid pointtype 8",
    "'#d678a8' dashtype (2,2,6,2) pointtype 10", "'#8a8a96' dashtype (6,6) pointtype 12",
    "'#b08060' dashtype (3,6) pointtype 1",      "'#4a5a2a' dashtype (9,3) pointtype 3"};

/// A method has the same line in every chart: that of its index here.
constexpr std::string_view kMethodKeys[] = {"on_demand_us",    "eager_us",        "paper_us",
                                            "paper_eager_us",  "crowd_us",        "hybrid_us",
                                            "aabb_refit_us",   "aabb_rebuild_us", "hash_us",
                                            "hash_overlap_us", "bd_tree_us",      "hash_crowd_us"};
static_assert(std::size(kMethodKeys) == std::size(kLines));

/// Series that are not methods use the lines in order.
std::size_t line_of(const Chart& chart, std::size_t series) {
  const auto* const found =
      std::find(std::begin(kMethodKeys), std::end(kMethodKeys), chart.y[series]);
  if (found == std::end(kMethodKeys)) return series % std::size(kLines);
  return static_cast<std::size_t>(found - std::begin(kMethodKeys));
}

/// The unit in brackets at the end: " [us]".
std::string unit_of(const std::string& title) {
  const std::size_t at = title.rfind(" [");
  return at == title.npos || title.back() != ']' ? "" : title.substr(at);
}

/// Without the unit if the axis names the same unit.
std::string series_title(const Chart& chart, const Column& column) {
  const std::string unit = unit_of(column.title);
  const bool is_told = unit == unit_of(chart.y_title);
  return is_told ? column.title.substr(0, column.title.size() - unit.size()) : column.title;
}

std::vector<double> values_of(const Table& table, std::span<const std::string> keys) {
  std::vector<double> figures;
  for (const std::string& key : keys)
    for (const std::vector<Cell>& row : table.rows)
      if (const Cell& cell = row[column_of(table, key)]; cell.figure)
        figures.push_back(*cell.figure);
  return figures;
}

std::string scales(const Chart& chart, const Table& table) {
  const std::vector<double> x = values_of(table, std::span(&chart.x, 1));
  const std::vector<double> y = values_of(table, chart.y);
  const Axes axes = chart.axes;
  const bool log_x = axes == Axes::logarithmic || axes == Axes::logarithmic_x;
  const bool log_y = axes == Axes::logarithmic || axes == Axes::logarithmic_y;
  return (log_x ? logarithmic_axis("x", x) : linear_axis("x", x)) +
         (log_y ? logarithmic_axis("y", y) : axis_from("y", chart.least_y));
}

std::string titles(const Chart& chart, const Table& table) {
  const Column& x = table.columns[column_of(table, chart.x)];
  return "set xlabel " + quoted(x.title) + " offset 0,0.4\nset ylabel " + quoted(chart.y_title) +
         "\nset title " + quoted(drawn_title(chart)) + "\n";
}

std::string plots(const Chart& chart, const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < chart.y.size(); ++i) {
    const Column& y = table.columns[column_of(table, chart.y[i])];
    text += (i == 0 ? "plot " : ", ") + ("$data using 1:" + std::to_string(i + 2)) +
            " with linespoints linewidth 1.6 pointsize 0.6 linecolor " + kLines[line_of(chart, i)] +
            " title " + quoted(series_title(chart, y));
  }
  return text + "\n";
}

/// Below the plot, so the plot keeps its width. A single line needs no key.
const char* key(const Chart& chart) {
  return chart.y.size() == 1
             ? "set key off\n"
             : "set key outside bottom center horizontal reverse Left samplen 3 height 0.6\n";
}

}  // namespace

std::string gnuplot_script(const Chart& chart, const Table& all, const fs::path& svg) {
  const Table table = drawn_rows(chart, all);
  return "set terminal svg size 760,440 font 'Helvetica,13' background 'white' noenhanced\n"
         "set encoding utf8\nset output " +
         quoted(svg.string()) + "\n$data << END\n" + data_block(chart, table) +
         "END\nset datafile separator tab\nset grid linecolor '#dddddd' linetype 1\n"
         "set border linecolor '#666666'\n" +
         key(chart) + titles(chart, table) + scales(chart, table) + plots(chart, table);
}

Result<void> draw_chart(const Chart& chart, const Table& table, const fs::path& svg) {
  fs::path file = svg;
  file.replace_extension(".gnuplot");
  const std::vector<std::string> command = {"gnuplot", file.string()};
  return draw({"gnuplot", "gnuplot-nox"}, command, file, gnuplot_script(chart, table, svg));
}

Result<void> render(const Picture& picture, const fs::path& png) {
  fs::path file = png;
  file.replace_extension(".pov");
  const std::vector<std::string> command = {"povray",
                                            "+I" + file.string(),
                                            "+O" + png.string(),
                                            "+W" + std::to_string(picture.width),
                                            "+H" + std::to_string(picture.height),
                                            "+A0.2",
                                            "-D",
                                            "-P",
                                            "+Q9"};
  return draw({"POV-Ray", "povray"}, command, file, picture.description);
}

}  // namespace pelt::reproduce
