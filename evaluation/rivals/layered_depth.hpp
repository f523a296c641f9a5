#pragma once

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

#include "evaluation/rivals/box.hpp"

#include <vector>

namespace pelt::rivals {

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
