#include "tools/pelt/bench/line_chart.hpp"

#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pelt::tools::bench {
namespace {

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
  if (value >= 1000) return output::with_commas(static_cast<std::uint64_t>(std::llround(value)));
  std::string text = output::fixed(value, value < 0.001 ? 5 : 3);
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

  static std::string plain(double value) { return output::fixed(value, 1); }

  static constexpr const char* kTicEnd = "font-size='11' text-anchor='end' fill='#666666'";
  static constexpr const char* kTicMiddle = "font-size='11' text-anchor='middle' fill='#666666'";

  const LineChart& chart_;
  std::ostringstream out_;
};

}  // namespace

std::string svg_of(const LineChart& chart) { return Drawing(chart).draw(); }

}  // namespace pelt::tools::bench
