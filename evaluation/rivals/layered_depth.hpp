#pragma once

/// Heidelberger, Teschner & Gross 2004, "Detection of collisions and self-collisions using
/// image-space techniques": yes or no for two bodies from pictures of them. Where the bodies' boxes
/// intersect, both are drawn by parallel rays along one axis into layered depth images: for each
/// pixel the depths of all surfaces on its ray, in order. Odd layers are entries and even ones
/// exits, so that a pixel knows where its ray is inside a body; bodies are in contact if some ray
/// is inside both at once.
///
/// This is an approximation. It misses what passes between the rays. It asks for closed surfaces:
/// of an open one, a ray that finds an odd number of layers drops the last, and layers pair up
/// wrongly behind a hole, so that bodies are missed there or seen where they are not. Where a body
/// overlaps itself, parity takes the overlap for outside. In return a body wholly inside another is
/// seen, which has no pair of triangles to report.
///
/// Strengthened: only triangles whose boxes reach the picture are drawn; the rays go along the
/// shortest edge of the intersection, which two bodies that push into each other share; edges are
/// drawn in whole numbers and by a fill rule, so that no ray passes between two triangles or meets
/// both.

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
