#pragma once

/// Line charts as SVG, side by side.

#include <string>
#include <utility>
#include <vector>

namespace pelt::tools::bench {

/// Values over a logarithmic axis.
struct Line {
  std::string colour, dashes;                     ///< as SVG; "": a solid line
  std::vector<std::pair<double, double>> points;  ///< ascending
};

enum class Scale { linear, logarithmic };

struct Panel {
  std::string title;
  Scale scale = Scale::linear;  ///< of the vertical axis
  double low = 0, high = 1;  ///< of the vertical axis; a logarithmic one begins at a power of ten
  std::string unit;          ///< follows the numbers of the vertical axis
  std::vector<Line> lines;
};

/// A row of panels with the same horizontal axis, which is logarithmic and in per cent.
struct PanelRow {
  std::string title;
  double first = 1, last = 100;  ///< of the horizontal axis, in per cent
  std::vector<Panel> panels;
};

struct LegendEntry {
  std::string colour, dashes, text;
};

struct LineChart {
  std::string title, note, x_title;  ///< the note is below the title
  std::vector<LegendEntry> legend;
  std::vector<PanelRow> rows;
};

std::string svg_of(const LineChart& chart);

}  // namespace pelt::tools::bench
