#pragma once

/// The subset of SVG that the figures need.

#include "balls.hpp"

#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

namespace pelt::test {

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

}  // namespace pelt::test
