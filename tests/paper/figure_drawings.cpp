#include "paper/figure_drawings.hpp"
#include "paper/balls.hpp"
#include "paper/figures.hpp"

#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

namespace pelt::test {
namespace {

// The subset of SVG that the figures need.

/// A drawing, with the current position of the plane's origin.
class Svg {
 public:
  /// `style` is a style sheet for the classes of the shapes.
  Svg(int width, int height, const char* title, const char* style) {
    print("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" role=\"img\">\n", width,
          height);
    print("<title>%s</title>\n<style>%s</style>\n", title, style);
    print("<rect width=\"%d\" height=\"%d\" fill=\"#fdfdfc\"/>\n", width, height);
  }

  /// Sets the scale to `scale` per unit and the origin to (x, y).
  void place(double x, double y, double scale) {
    x_ = x;
    y_ = y;
    scale_ = scale;
  }

  void circle(const char* shape, const Ball& ball) {
    print("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n", shape, x(ball.centre),
          y(ball.centre), scale_ * ball.radius);
  }

  void dot(const char* shape, const Vec3d& at, const std::string& colour) {
    print("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", shape, x(at),
          y(at), colour.c_str());
  }

  void line(const char* shape, const Vec3d& from, const Vec3d& to) {
    print("<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", shape, x(from),
          y(from), x(to), y(to));
  }

  /// The convex hull of balls of equal radius whose centres are the vertices of a convex polygon,
  /// counter-clockwise: the sides are moved outwards and joined by arcs.
  void hull(const char* shape, const std::vector<Ball>& balls) {
    print("<path class=\"%s\" d=\"", shape);
    const double radius = scale_ * balls[0].radius;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec3d& from = balls[i].centre;
      const Vec3d& to = balls[(i + 1) % balls.size()].centre;
      const Vec3d side = to - from;
      const Vec3d out = (balls[i].radius / length(side)) * Vec3d(side.y, -side.x, 0);
      const Vec3d begin = from + out, end = to + out;
      if (i == 0) {
        print("M%.1f %.1f", x(begin), y(begin));
      } else {
        print("A%.1f %.1f 0 0 0 %.1f %.1f", radius, radius, x(begin), y(begin));
      }
      print("L%.1f %.1f", x(end), y(end));
    }
    const Vec3d side = balls[1].centre - balls[0].centre;
    const Vec3d close =
        balls[0].centre + (balls[0].radius / length(side)) * Vec3d(side.y, -side.x, 0);
    print("A%.1f %.1f 0 0 0 %.1f %.1fZ\"/>\n", radius, radius, x(close), y(close));
  }

  /// A label with a subscript: text_subscript tail.
  void label(const Vec3d& at, const char* text, const char* subscript = "", const char* tail = "") {
    print("<text x=\"%.1f\" y=\"%.1f\">%s", x(at), y(at), text);
    if (*subscript != '\0') print("<tspan class=\"sub\" dy=\"4\">%s</tspan>", subscript);
    if (*tail != '\0') print("<tspan dy=\"-4\">%s</tspan>", tail);
    print("</text>\n");
  }

  void caption(const Vec3d& at, const char* text) {
    print("<text class=\"caption\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", x(at), y(at), text);
  }

  std::string finish() && { return std::move(text_) + "</svg>\n"; }

 private:
  double x(const Vec3d& v) const { return x_ + scale_ * v.x; }
  double y(const Vec3d& v) const { return y_ - scale_ * v.y; }

  __attribute__((format(printf, 2, 3))) void print(const char* format, ...) {
    char line[1024];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    text_ += line;
  }

  double x_ = 0, y_ = 0, scale_ = 1;
  std::string text_;
};

constexpr const char* kStyle = R"(
text{font:italic 15px Georgia,serif;fill:#222;text-anchor:middle}
.sub{font-size:11px}
.caption{font:13px Helvetica,Arial,sans-serif;fill:#555}
.sphere,.corner{fill:none;stroke:#333;stroke-width:1.2}
.corner{stroke:#1c6b4a;stroke-width:1.4}
.loose{fill:#ececf1;stroke:#8a8a9a;stroke-width:1.2}
.tight{fill:#cfe6da;stroke:#1c6b4a;stroke-width:1.4}
.ghost{fill:none;stroke:#b5b5c0;stroke-dasharray:4 3}
.bone{stroke-width:5;stroke-linecap:round;stroke:#d9cdb8}
.path{stroke:#999;stroke-width:1}
.weights{stroke:#222;stroke-width:2.2}
.vertex{stroke:#fff;stroke-width:1}
)";

/// A colour between those of joint 1 and joint 2, by the weight of joint 1.
std::string colour_of(double weight) {
  const double a[3] = {200, 80, 20}, b[3] = {30, 80, 200};
  // All weights of the figure are near one half; spreads them.
  const double share = std::clamp(5 * (weight - 0.5) + 0.5, 0.0, 1.0);
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x",
                static_cast<unsigned>(share * a[0] + (1 - share) * b[0]),
                static_cast<unsigned>(share * a[1] + (1 - share) * b[1]),
                static_cast<unsigned>(share * a[2] + (1 - share) * b[2]));
  return text;
}

/// The two bones: nearly side by side in the reference posture, each moved by its joint.
void draw_bones(Svg& svg, const Figure2& figure, bool animated) {
  for (std::size_t j = 0; j < 2; ++j) {
    const double side = j == 0 ? -1 : 1;
    const Vec3d tip(side * 0.35, 1.6, 0);
    svg.line("bone", figure.pivot, animated ? figure.joints[j](tip) : tip);
    const Vec3d at(side * 0.75, 1.75, 0);
    svg.label(animated ? figure.joints[j](at) : at, "j", j == 0 ? "1" : "2");
  }
}

void draw_reference(Svg& svg, const Figure2& figure) {
  draw_bones(svg, figure, false);
  svg.circle("sphere", figure.sphere);
  svg.label({1.2, -0.65, 0}, "S");
  const Vec3d offsets[3] = {{-0.3, 0.15, 0}, {-0.5, -0.3, 0}, {0.35, 0.15, 0}};
  const char* numbers[3] = {"1", "2", "3"};
  for (std::size_t i = 0; i < 3; ++i) {
    svg.dot("vertex", figure.vertices[i], colour_of(figure.weights[i][0]));
    svg.label(figure.vertices[i] + offsets[i], "v", numbers[i]);
  }
}

/// The posed vertices on the parts of their lines that the weights <low, high> allow.
void draw_posed(Svg& svg, const Figure2& figure, double low, double high) {
  for (std::size_t i = 0; i < 3; ++i) {
    svg.line("path", figure.image(0, i), figure.image(1, i));
    svg.line("weights", figure.blended(i, low), figure.blended(i, high));
  }
  for (std::size_t i = 0; i < 3; ++i)
    svg.dot("vertex", figure.posed(i), colour_of(figure.weights[i][0]));
}

void label_images(Svg& svg, const Figure2& figure) {
  const char* numbers[2] = {"j1", "j2"};
  for (std::size_t j = 0; j < 2; ++j) {
    const double side = j == 0 ? -1 : 1;
    svg.label(figure.joints[j](figure.sphere.centre) + Vec3d(side * 1.35, -0.65, 0), "C",
              numbers[j], "S");
  }
}

}  // namespace

std::string draw_figure2() {
  const Figure2 figure;
  Svg svg(960, 275, "Bounding volumes by equations 2 and 4", kStyle);
  svg.place(130, 115, 42);
  draw_reference(svg, figure);
  svg.caption({0, -3.35, 0}, "reference posture");

  svg.place(420, 115, 42);
  draw_bones(svg, figure, true);
  svg.hull("loose", figure.images_of_sphere());
  for (const Ball& ball : figure.images_of_sphere()) svg.circle("sphere", ball);
  label_images(svg, figure);
  draw_posed(svg, figure, 0, 1);
  svg.label({0, -2.05, 0}, "BV", "1");
  svg.caption({0, -3.35, 0}, "any weights: enclosing radius 2.5");

  svg.place(770, 115, 42);
  draw_bones(svg, figure, true);
  for (const Ball& ball : figure.images_of_sphere()) svg.circle("ghost", ball);
  label_images(svg, figure);
  svg.hull("tight", figure.corners());
  draw_posed(svg, figure, figure.intervals()[0].low, figure.intervals()[0].high);
  svg.label({0, -2.05, 0}, "BV", "2");
  svg.caption({0, -3.35, 0},
              "weights within \xe2\x9f\xa8"
              "0.4, 0.6\xe2\x9f\xa9: enclosing radius 1.3");
  return std::move(svg).finish();
}

std::string draw_figure3() {
  const Figure3 figure;
  std::vector<Ball> around = figure.corners();
  // Counter-clockwise; the two ends of the cut replace S_1.
  std::sort(around.begin(), around.end(), [](const Ball& a, const Ball& b) {
    const auto angle = [](const Ball& ball) {
      const Vec3d middle(0, 0.2, 0);
      return std::atan2(ball.centre.y - middle.y, ball.centre.x - middle.x);
    };
    return angle(a) < angle(b);
  });
  const char* numbers[4] = {"1", "2", "3", "4"};

  Svg svg(960, 340, "The generalised convex hull of three spheres", kStyle);
  svg.place(240, 190, 40);
  svg.hull("loose", figure.spheres);
  svg.hull("tight", around);
  for (std::size_t j = 0; j < 3; ++j) {
    svg.circle("sphere", figure.spheres[j]);
    svg.label(figure.spheres[j].centre - Vec3d(0, 0.12, 0), "S", numbers[j]);
  }
  svg.label({2.15, 2.2, 0}, "CH", "1");
  svg.label({0, 0, 0}, "CH", "2");
  svg.caption({0, -2.9, 0},
              "weight of S\xe2\x82\x81 within \xe2\x9f\xa8"
              "0, 0.6\xe2\x9f\xa9");

  svg.place(720, 190, 40);
  svg.hull("ghost", figure.spheres);
  svg.hull("tight", around);
  for (std::size_t a = 0; a < around.size(); ++a) {
    svg.circle("corner", around[a]);
    svg.label(around[a].centre - Vec3d(0, 0.12, 0), "R", numbers[a]);
  }
  svg.caption({0, -2.9, 0}, "the ordinary hull of four corner spheres");
  return std::move(svg).finish();
}

}  // namespace pelt::test
