#include "evaluation/bench/anytime_chart.hpp"

#include "text/format.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace pelt::lab {
namespace {

// --- line charts as SVG, side by side

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

constexpr double kMargin = 28, kPanelWidth = 300, kPanelHeight = 200, kPanelGap = 64;
constexpr double kLeft = kMargin + 40;  // room for the numbers of an axis
constexpr double kRowHead = 54, kRowFoot = 52, kTitle = 44, kLegendLine = 22;
constexpr double kWholeComplete = 100;  // per cent
constexpr const char *kInk = "#222222", *kGrey = "#666666", *kGrid = "#e4e4e4";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

/// A number with at most three decimals, and without trailing zeros.
std::string number(double value) {
  if (value >= 1000) return text::with_commas(static_cast<std::uint64_t>(std::llround(value)));
  std::string text = text::fixed(value, value < 0.001 ? 5 : 3);
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
    const bool is_point = text.back() == '.';
    text.pop_back();
    if (is_point) break;
  }
  return text;
}

std::string dash_attribute(const std::string& dashes) {
  return dashes.empty() ? "" : " stroke-dasharray='" + dashes + "'";
}

/// Places on one axis.
class Axis {
 public:
  Axis(Scale scale, double low, double high, double from, double to)
      : scale_(scale), low_(low), high_(high), from_(from), to_(to) {}

  double place(double value) const {
    const double share = (measure(std::clamp(value, low_, high_)) - measure(low_)) /
                         (measure(high_) - measure(low_));
    return from_ + share * (to_ - from_);
  }

  /// Values with a number and a line of the grid.
  std::vector<double> tics() const {
    std::vector<double> tics;
    if (scale_ == Scale::linear) {
      const double step = linear_step();
      for (int i = 0; i * step <= high_ * (1 + 1e-9); ++i) tics.push_back(i * step);
      return tics;
    }
    for (double tic = low_; tic <= high_ * (1 + 1e-9); tic *= 10) tics.push_back(tic);
    return tics;
  }

 private:
  double measure(double value) const { return scale_ == Scale::linear ? value : std::log10(value); }

  /// 1, 2 or 5 times a power of ten, so that there are four to ten steps.
  double linear_step() const {
    const double power = std::pow(10, std::floor(std::log10(high_ / 4)));
    for (const double factor : {5.0, 2.0})
      if (factor * power <= high_ / 4) return factor * power;
    return power;
  }

  Scale scale_;
  double low_, high_, from_, to_;
};

class Drawing {
 public:
  explicit Drawing(const LineChart& chart) : chart_(chart) {}

  std::string draw() {
    double y = kMargin + kTitle;
    text(kMargin, y - 32, chart_.title, "font-size='17' font-weight='600'");
    text(kMargin, y - 12, chart_.note, std::string("font-size='12.5' fill='") + kGrey + "'");
    for (const LegendEntry& entry : chart_.legend) {
      line(kMargin, y + 6, kMargin + 34, y + 6, entry.colour, 2.4, entry.dashes);
      text(kMargin + 44, y + 10.5, entry.text, "font-size='13'");
      y += kLegendLine;
    }
    for (const PanelRow& row : chart_.rows) y = draw_row(row, y);
    return head(y + kMargin / 2) + out_.str() + "</svg>\n";
  }

 private:
  std::string head(double height) const {
    std::size_t panels = 1;
    for (const PanelRow& row : chart_.rows) panels = std::max(panels, row.panels.size());
    const double width =
        kLeft + static_cast<double>(panels) * (kPanelWidth + kPanelGap) - kPanelGap + kMargin;
    return "<svg xmlns='http://www.w3.org/2000/svg' width='" + plain(width) + "' height='" +
           plain(height) + "' viewBox='0 0 " + plain(width) + " " + plain(height) +
           "' font-family='Helvetica, Arial, sans-serif' fill='" + kInk +
           "'>\n<rect width='100%' height='100%' fill='white'/>\n";
  }

  /// Returns the place below the row.
  double draw_row(const PanelRow& row, double y) {
    text(kMargin, y + 26, row.title, "font-size='14' font-weight='600'");
    const double top = y + kRowHead;
    double x = kLeft;
    for (const Panel& panel : row.panels) {
      draw_panel(row, panel, x, top);
      x += kPanelWidth + kPanelGap;
    }
    return top + kPanelHeight + kRowFoot;
  }

  void draw_panel(const PanelRow& row, const Panel& panel, double left, double top) {
    const double right = left + kPanelWidth, bottom = top + kPanelHeight;
    const Axis x(Scale::logarithmic, row.first, row.last, left, right);
    const Axis y(panel.scale, panel.low, panel.high, bottom, top);
    text(left, top - 8, panel.title, "font-size='12.5'");
    for (const double tic : y.tics()) {
      line(left, y.place(tic), right, y.place(tic), kGrid, 1);
      text(left - 6, y.place(tic) + 4, number(tic) + panel.unit, kTicEnd);
    }
    for (const double tic : x.tics()) {
      line(x.place(tic), top, x.place(tic), bottom, kGrid, 1);
      text(x.place(tic), bottom + 16, number(tic) + " %", kTicMiddle);
    }
    line(x.place(kWholeComplete), top, x.place(kWholeComplete), bottom, kGrey, 1, "2 3");
    line(left, bottom, right, bottom, kGrey, 1);
    for (const Line& drawn : panel.lines) draw_line(drawn, x, y);
    text((left + right) / 2, bottom + 34, chart_.x_title,
         std::string("font-size='11.5' text-anchor='middle' fill='") + kGrey + "'");
  }

  void draw_line(const Line& drawn, const Axis& x, const Axis& y) {
    out_ << "<polyline fill='none' stroke-width='2.2' stroke-linejoin='round' stroke='"
         << drawn.colour << "'" << dash_attribute(drawn.dashes) << " points='";
    for (const auto& [at, value] : drawn.points)
      out_ << plain(x.place(at)) << "," << plain(y.place(value)) << " ";
    out_ << "'/>\n";
  }

  void line(double x0, double y0, double x1, double y1, const std::string& colour, double width,
            const std::string& dashes = "") {
    out_ << "<line x1='" << plain(x0) << "' y1='" << plain(y0) << "' x2='" << plain(x1) << "' y2='"
         << plain(y1) << "' stroke='" << colour << "' stroke-width='" << plain(width) << "'"
         << dash_attribute(dashes) << "/>\n";
  }

  void text(double x, double y, const std::string& words, const std::string& attributes) {
    out_ << "<text x='" << plain(x) << "' y='" << plain(y) << "' " << attributes << ">"
         << escaped(words) << "</text>\n";
  }

  static std::string plain(double value) { return text::fixed(value, 1); }

  static constexpr const char* kTicEnd = "font-size='11' text-anchor='end' fill='#666666'";
  static constexpr const char* kTicMiddle = "font-size='11' text-anchor='middle' fill='#666666'";

  const LineChart& chart_;
  std::ostringstream out_;
};

// --- the chart of a search

/// Dark enough on white, and distinguishable for people with red-green colour blindness.
constexpr std::pair<const char*, const char*> kStyles[] = {
    {"#1c6b4a", ""}, {"#2f5fa8", "7 4"}, {"#c28a00", "2 3"}, {"#b5533c", "12 4 3 4"}};

/// Smaller shares of undecided pairs are at the lower end of the axis.
constexpr double kLeastUndecided = 1e-4;  // per cent

const auto& style_of(std::size_t method) { return kStyles[method % std::size(kStyles)]; }

/// A line for each method, of `value(known)`, until the method is complete.
template <typename Value>
std::vector<Line> lines_of(const AnytimeSceneFigures& scene, const Value& value) {
  std::vector<Line> lines;
  for (std::size_t m = 0; m < scene.methods.size(); ++m) {
    const auto& [colour, dashes] = style_of(m);
    lines.push_back({colour, dashes, {}});
    for (const AnytimeRung& rung : scene.methods[m].course) {
      lines.back().points.emplace_back(100 * rung.time, value(rung.known));
      if (rung.known.undecided == 0) break;
    }
  }
  return lines;
}

double highest_of(const std::vector<Line>& lines) {
  double highest = 0;
  for (const Line& line : lines)
    for (const auto& [at, value] : line.points) highest = std::max(highest, value);
  return highest > 0 ? highest : 1;
}

PanelRow row_of(const AnytimeSceneFigures& scene) {
  PanelRow row;
  row.title = scene.scene + ": " + text::counted(scene.pairs, "pair") +
              " of instances in contact, " + text::with_commas(scene.triangles) + " triangles";
  row.last = 100 * std::max(scene.methods[0].course.back().time, 1.0);
  row.panels.push_back({"contacts listed", Scale::linear, 0, 100, " %",
                        lines_of(scene, [](const auto& known) { return 100 * known.listed; })});
  row.panels.push_back({"pairs of triangles undecided", Scale::logarithmic, kLeastUndecided, 100,
                        " %",
                        lines_of(scene, [](const auto& known) { return 100 * known.undecided; })});
  std::vector<Line> longest = lines_of(scene, [](const auto& known) { return known.resolution; });
  const double highest = highest_of(longest);
  row.panels.push_back({"longest side of an open region, in model units", Scale::linear, 0, highest,
                        "", std::move(longest)});
  return row;
}

/// With the area of each scene.
std::vector<LegendEntry> legend_of(const std::vector<AnytimeSceneFigures>& scenes) {
  std::vector<LegendEntry> legend;
  for (std::size_t m = 0; m < scenes[0].methods.size(); ++m) {
    const auto& [colour, dashes] = style_of(m);
    legend.push_back({colour, dashes, scenes[0].methods[m].title + ": area"});
    for (const AnytimeSceneFigures& scene : scenes)
      legend.back().text.append(" ").append(text::fixed(scene.methods[m].area_over_work, 2));
  }
  return legend;
}

}  // namespace

std::string anytime_chart(const std::vector<AnytimeSceneFigures>& scenes) {
  LineChart chart;
  chart.title = "What is known when a query is stopped";
  chart.note =
      "Means over the pairs. Area: below contacts listed, over each method's own work, 1 if all "
      "are "
      "listed at once. Dotted: the time of a complete search in the order contacts.";
  chart.x_title = "time, in per cent of a complete search";
  chart.legend = legend_of(scenes);
  for (const AnytimeSceneFigures& scene : scenes) chart.rows.push_back(row_of(scene));
  return Drawing(chart).draw();
}

}  // namespace pelt::lab
