#include "tools/reproduce/chart.hpp"

#include "tools/reproduce/drawing.hpp"

#include <sstream>

namespace pelt::reproduce {
namespace {

namespace fs = std::filesystem;

/// In single quotes nothing but these has a meaning for gnuplot.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' ? "''" : std::string(1, c);
  return "'" + inside + "'";
}

std::string title_of(const Chart& chart) {
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

/// The table as gnuplot reads it: tabs between columns, NaN where there is no figure.
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

/// Dark enough on white, and told apart by those who confuse red and green.
constexpr const char* kColours =
    "set linetype 1 linecolor '#1c6b4a'\nset linetype 2 linecolor '#b5533c'\n"
    "set linetype 3 linecolor '#2f5fa8'\nset linetype 4 linecolor '#c28a00'\n"
    "set linetype 5 linecolor '#7a4fa0'\nset linetype 6 linecolor '#333333'\n"
    "set linetype 7 linecolor '#4fa7b8'\nset linetype 8 linecolor '#9aa05a'\n"
    "set linetype 9 linecolor '#d678a8'\nset linetype 10 linecolor '#9a9aa6'\n";

/// Where heights are not logarithmic they begin at zero, so that they compare.
const char* scales(Axes axes) {
  switch (axes) {
    case Axes::linear:
      return "set yrange [0:*]\n";
    case Axes::logarithmic:
      return "set logscale xy\nset format '%.10g'\n";
    case Axes::logarithmic_y:
      return "set logscale y\nset format y '%.10g'\n";
  }
  return "";
}

std::string axes(const Chart& chart, const Table& table) {
  const Column& x = table.columns[column_of(table, chart.x)];
  std::string text = "set xlabel " + quoted(x.title) + "\nset ylabel " + quoted(chart.y_title) +
                     "\nset title " + quoted(title_of(chart)) + "\n";
  return text + scales(chart.axes);
}

}  // namespace

std::string gnuplot_script(const Chart& chart, const Table& table, const fs::path& svg) {
  std::string plots;
  for (std::size_t i = 0; i < chart.y.size(); ++i) {
    const Column& y = table.columns[column_of(table, chart.y[i])];
    plots += (i == 0 ? "plot " : ", ") + ("$data using 1:" + std::to_string(i + 2)) +
             " with linespoints linewidth 2 pointtype 7 pointsize 0.5 title " + quoted(y.title);
  }
  return "set terminal svg size 760,420 font 'Helvetica,13' background 'white' noenhanced\n"
         "set output " +
         quoted(svg.string()) + "\n$data << END\n" + data_block(chart, table) +
         "END\nset datafile separator tab\nset key outside right reverse Left\nset grid\n" +
         kColours + axes(chart, table) + plots + "\n";
}

Result<void> draw_chart(const Chart& chart, const Table& table, const fs::path& svg) {
  fs::path file = svg;
  file.replace_extension(".gnuplot");
  const std::vector<std::string> command = {"gnuplot", file.string()};
  return draw({"gnuplot", "gnuplot-nox"}, command, file, gnuplot_script(chart, table, svg));
}

}  // namespace pelt::reproduce
