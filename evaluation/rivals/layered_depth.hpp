#pragma once

/// Finds the pixels whose centres a triangle covers, seen along an axis.
///
/// Vertices are rounded to multiples of 1/256 of a pixel, and the sides of edges are decided in
/// integers. A centre on an edge belongs to exactly one of the two triangles that share the edge
/// (the top-left rule of graphics hardware). Every ray therefore crosses a closed surface an even
/// number of times.
///
/// Heidelberger, Teschner & Gross 2004, "Detection of collisions and self-collisions using
/// image-space techniques": decides from images whether two bodies touch. In the intersection of
/// the bodies' boxes, both are drawn by parallel rays along one axis into layered depth images,
/// which have the depths of all surfaces on the ray of each pixel, in order. Odd layers are entries
/// and even layers exits, so each pixel has the intervals in which its ray is inside a body. Bodies
/// are in contact if some ray is inside both at once.
///
/// This is an approximation. It misses contacts between the rays. It requires closed surfaces: if a
/// ray finds an odd number of layers, the last is dropped, and behind a hole layers pair up
/// wrongly, so bodies are missed there or found where they are not. Where a body overlaps itself,
/// parity treats the overlap as outside. On the other hand, it finds a body wholly inside another,
/// which has no intersecting triangles.
///
/// Strengthened: only triangles whose boxes reach the image are drawn; the rays are parallel to the
/// shortest edge of the intersection, which two bodies that push into each other share; edges are
/// drawn with integers and a fill rule, so no ray passes between two triangles or hits both.

#include "evaluation/rivals/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pelt::rivals {

class Rasteriser {
 public:
  /// Draws onto the face of `where` across its shortest edge, with `resolution` squared pixels.
  Rasteriser(const Box4& where, std::uint32_t resolution)
      : low_(where.low), high_(where.high), resolution_(resolution) {
    const Float4 extent = where.high - where.low;
    depth_axis_ = extent[0] <= extent[1] ? 0 : 1;
    if (extent[2] < extent[depth_axis_]) depth_axis_ = 2;
    for (int i = 0; i < 2; ++i) {
      axis_[i] = (depth_axis_ + 1 + i) % 3;
      const double scale = resolution / double{extent[axis_[i]]};
      scale_[i] = std::isfinite(scale) ? scale : 0;
    }
  }

  /// Whether a triangle in `box` may cover any pixel.
  bool sees(const Box4& box) const {
    return std::all_of(axis_.begin(), axis_.end(), [&](int axis) {
      return box.low[axis] <= high_[axis] && low_[axis] <= box.high[axis];
    });
  }

  /// Calls `visit(pixel, depth)` for each pixel that a triangle covers.
  template <typename Visit>
  void draw(const std::array<Float4, 3>& corners, const Visit& visit) const {
    std::array<Point, 3> p = {snap(corners[0]), snap(corners[1]), snap(corners[2])};
    std::array<double, 3> depth;
    for (std::size_t k = 0; k < 3; ++k) depth[k] = double{corners[k][depth_axis_]};
    std::int64_t area = side(p[0], p[1], p[2]);
    if (area == 0) return;
    if (area < 0) {
      std::swap(p[1], p[2]), std::swap(depth[1], depth[2]);
      area = -area;
    }
    const auto [first_x, end_x] = pixels(p[0].x, p[1].x, p[2].x);
    const auto [first_y, end_y] = pixels(p[0].y, p[1].y, p[2].y);
    for (std::int64_t y = first_y; y < end_y; ++y)
      for (std::int64_t x = first_x; x < end_x; ++x) {
        const Point centre = {x * kUnit + kUnit / 2, y * kUnit + kUnit / 2};
        const std::int64_t w0 = side(p[1], p[2], centre), w1 = side(p[2], p[0], centre);
        const std::int64_t w2 = side(p[0], p[1], centre);
        if (!covers(w0, p[1], p[2]) || !covers(w1, p[2], p[0]) || !covers(w2, p[0], p[1])) continue;
        const double sum = static_cast<double>(w0) * depth[0] + static_cast<double>(w1) * depth[1] +
                           static_cast<double>(w2) * depth[2];
        visit(static_cast<std::uint32_t>(y * resolution_ + x),
              static_cast<float>(sum / static_cast<double>(area)));
      }
  }

 private:
  static constexpr std::int64_t kUnit = 256;  // of a pixel's edge

  struct Point {
    std::int64_t x, y;
  };

  /// Clamps coordinates far outside the picture, so that areas fit into 64 bits.
  std::int64_t snap(float value, int i) const {
    constexpr double kFar = 0x1p29;
    const double pixels = (double{value} - double{low_[axis_[i]]}) * scale_[i];
    return std::llround(std::clamp(pixels * kUnit, -kFar, kFar));
  }
  Point snap(const Float4& corner) const {
    return {snap(corner[axis_[0]], 0), snap(corner[axis_[1]], 1)};
  }

  /// Twice the area of a triangle, positive if it turns counter-clockwise.
  static std::int64_t side(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  /// Decides which of the two triangles at an edge covers the centres on the edge.
  static bool covers(std::int64_t side, const Point& from, const Point& to) {
    return side > 0 || (side == 0 && (from.y > to.y || (from.y == to.y && from.x < to.x)));
  }

  struct Range {
    std::int64_t first, end;
  };

  /// The pixels whose centres may be between the least and the largest of three coordinates.
  Range pixels(std::int64_t a, std::int64_t b, std::int64_t c) const {
    const auto [least, most] = std::minmax({a, b, c});
    return {std::max<std::int64_t>(least / kUnit, 0),
            std::min<std::int64_t>(most / kUnit + 1, resolution_)};
  }

  Float4 low_, high_;
  std::int64_t resolution_;
  int depth_axis_ = 0;
  std::array<int, 2> axis_ = {};
  std::array<double, 2> scale_ = {};
};

class LayeredDepth {
 public:
  /// Images of `resolution` by `resolution` pixels, at most 4096.
  explicit LayeredDepth(std::uint32_t resolution) : resolution_(resolution) {}

  /// Adds a body. Bodies are numbered in the order of the calls. `triangles` must outlive this
  /// object.
  void add(std::span<const Triangle> triangles) { bodies_.push_back({triangles, {}, {}}); }

  /// Sets the posed vertices of a body. `positions` must stay unchanged until the next update.
  void update(std::uint32_t body, std::span<const Vec3> positions);

  /// Whether two bodies seem to overlap. Precondition: both have been updated.
  bool touch(std::uint32_t a, std::uint32_t b);

 private:
  struct Body {
    std::span<const Triangle> triangles;
    Points points;
    Box4 box;
  };

  /// A surface hit by the ray of a pixel.
  struct Layer {
    std::uint32_t pixel;
    float depth;
  };

  void draw(const Body& body, const Box4& where, std::vector<Layer>& layers) const;
  static bool share_space(std::span<const Layer> a, std::span<const Layer> b);

  std::uint32_t resolution_;
  std::vector<Body> bodies_;
  std::vector<Layer> layers_a_, layers_b_;
};

}  // namespace pelt::rivals
