#include "evaluation/bench/anytime_figures.hpp"

#include "text/format.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace pelt::lab {
namespace {

/// Mean of `value(x)` for x from 0 to 1, by the trapezoidal rule.
template <typename Value>
double area_of(const Value& value) {
  double sum = (value(0.0) + value(1.0)) / 2;
  for (std::size_t i = 1; i < kAnytimeSlices; ++i)
    sum += value(static_cast<double>(i) / kAnytimeSlices);
  return sum / kAnytimeSlices;
}

/// std::lerp, unlike a weighted sum, never decreases where both ends are alike or increase.
AnytimePoint between(const AnytimePoint& a, const AnytimePoint& b, double part) {
  return {std::lerp(a.listed, b.listed, part), std::lerp(a.undecided, b.undecided, part),
          std::lerp(a.resolution, b.resolution, part)};
}

constexpr int kStepsPerDecade = 30;

/// The curves of one method, and the times of complete searches of the same pairs.
class Pairs {
 public:
  Pairs(std::span<const AnytimeCurve> curves, std::span<const AnytimeCurve> units)
      : curves_(curves), units_(units) {}

  /// Mean of `value(curve, time of a complete search)`.
  template <typename Value>
  auto mean(const Value& value) const {
    auto sum = value(curves_[0], units_[0].complete_us());
    for (std::size_t c = 1; c < curves_.size(); ++c)
      sum = sum + value(curves_[c], units_[c].complete_us());
    return sum / static_cast<double>(curves_.size());
  }

  AnytimeRung after_work(double share) const {
    return {share,
            mean([&](const AnytimeCurve& c, double unit) { return c.time_us(share) / unit; }),
            mean([&](const AnytimeCurve& c, double) { return c.at_work(share); })};
  }

  AnytimeRung after_time(double share) const {
    return {share, share,
            mean([&](const AnytimeCurve& c, double unit) { return c.at_time(share * unit); })};
  }

  /// The time after which the searches of all pairs are complete.
  double end() const {
    double end = 1;
    for (std::size_t c = 0; c < curves_.size(); ++c)
      end = std::max(end, curves_[c].complete_us() / units_[c].complete_us());
    return end;
  }

  std::uint64_t longest_step() const {
    std::uint64_t longest = 0;
    for (const AnytimeCurve& curve : curves_) longest = std::max(longest, curve.longest_step);
    return longest;
  }

 private:
  std::span<const AnytimeCurve> curves_, units_;
};

AnytimeMethodFigures figures_of(const AnytimeRecord& record, const Pairs& pairs, double end) {
  AnytimeMethodFigures figures;
  figures.method = record.method;
  figures.title = record.title;
  figures.work =
      pairs.mean([](const AnytimeCurve& c, double) { return static_cast<double>(c.work); });
  figures.complete_us = pairs.mean([](const AnytimeCurve& c, double) { return c.complete_us(); });
  figures.longest_step = pairs.longest_step();
  figures.area_over_work =
      pairs.mean([](const AnytimeCurve& c, double) { return area_over_work(c); });
  figures.area_over_time = pairs.mean(area_over_time);
  for (const double share : kAnytimeRungs) {
    figures.over_work.push_back(pairs.after_work(share));
    figures.over_time.push_back(pairs.after_time(share));
  }
  const int last = static_cast<int>(std::ceil(kStepsPerDecade * std::log10(end)));
  for (int step = -2 * kStepsPerDecade; step <= last; ++step)
    figures.course.push_back(
        pairs.after_time(std::pow(10, static_cast<double>(step) / kStepsPerDecade)));
  return figures;
}

}  // namespace

AnytimePoint operator+(const AnytimePoint& a, const AnytimePoint& b) {
  return {a.listed + b.listed, a.undecided + b.undecided, a.resolution + b.resolution};
}

AnytimePoint operator/(const AnytimePoint& point, double divisor) {
  return {point.listed / divisor, point.undecided / divisor, point.resolution / divisor};
}

AnytimePoint AnytimeCurve::at_work(double share) const {
  const double slice = share * kAnytimeSlices;
  const std::size_t before = std::min(static_cast<std::size_t>(slice), kAnytimeSlices - 1);
  const double part = slice - static_cast<double>(before);
  return between(points[before], points[before + 1], part);
}

double AnytimeCurve::time_us(double share) const {
  std::size_t after = 1;
  while (after + 1 < kTimedShares.size() && kTimedShares[after] < share) ++after;
  const double begin = kTimedShares[after - 1], end = kTimedShares[after];
  const double part = (share - begin) / (end - begin);
  return std::lerp(times_us[after - 1], times_us[after], part);
}

/// Noise can make the time of a share less than that of a smaller share. Of several shares with
/// this time, takes the greatest.
AnytimePoint AnytimeCurve::at_time(double us) const {
  std::size_t last = kTimedShares.size() - 1;
  while (last > 0 && times_us[last] > us) --last;
  if (times_us[last] > us) return points[0];
  if (last + 1 == kTimedShares.size()) return points[kAnytimeSlices];
  const double part = (us - times_us[last]) / (times_us[last + 1] - times_us[last]);
  return at_work(std::lerp(kTimedShares[last], kTimedShares[last + 1], part));
}

double area_over_work(const AnytimeCurve& curve) {
  return area_of([&](double share) { return curve.at_work(share).listed; });
}

double area_over_time(const AnytimeCurve& curve, double end_us) {
  return area_of([&](double share) { return curve.at_time(share * end_us).listed; });
}

std::vector<AnytimeMethodFigures> figures_of(std::span<const AnytimeRecord> records,
                                             std::size_t unit) {
  std::vector<Pairs> all;
  double end = 1;
  for (const AnytimeRecord& record : records) {
    all.emplace_back(record.curves, records[unit].curves);
    end = std::max(end, all.back().end());
  }
  std::vector<AnytimeMethodFigures> figures;
  for (std::size_t m = 0; m < records.size(); ++m)
    figures.push_back(figures_of(records[m], all[m], end));
  return figures;
}

const AnytimeMethodFigures* find_method(const AnytimeSceneFigures& scene, std::string_view method) {
  const auto found =
      std::find_if(scene.methods.begin(), scene.methods.end(),
                   [&](const AnytimeMethodFigures& m) { return m.method == method; });
  return found == scene.methods.end() ? nullptr : &*found;
}

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
