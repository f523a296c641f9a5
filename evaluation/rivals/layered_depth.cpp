#include "evaluation/rivals/layered_depth.hpp"

namespace pelt::rivals {

void LayeredDepth::update(std::uint32_t body, std::span<const Vec3> positions) {
  Body& moved = bodies_[body];
  moved.points = Points(positions);
  moved.box = detail::empty_box();
  for (std::uint32_t v = 0; v < positions.size(); ++v)
    moved.box = unite(moved.box, {moved.points[v], moved.points[v]});
}

bool LayeredDepth::touch(std::uint32_t a, std::uint32_t b) {
  const Body &body_a = bodies_[a], &body_b = bodies_[b];
  if (!overlap(body_a.box, body_b.box)) return false;
  const Box4 where = intersect(body_a.box, body_b.box);
  draw(body_a, where, layers_a_);
  if (layers_a_.empty()) return false;
  draw(body_b, where, layers_b_);
  return share_space(layers_a_, layers_b_);
}

/// Fills the layers of each pixel, from near to far. Draws the whole ray and not only its part
/// inside the box, because parity is counted from the outside.
void LayeredDepth::draw(const Body& body, const Box4& where, std::vector<Layer>& layers) const {
  const Rasteriser rasteriser(where, resolution_);
  layers.clear();
  for (const Triangle& t : body.triangles)
    if (rasteriser.sees(body.points.box_of(t)))
      rasteriser.draw({body.points[t[0]], body.points[t[1]], body.points[t[2]]},
                      [&](std::uint32_t pixel, float depth) {
                        layers.push_back({pixel, depth});
                      });
  std::sort(layers.begin(), layers.end(), [](const Layer& l, const Layer& m) {
    return l.pixel != m.pixel ? l.pixel < m.pixel : l.depth < m.depth;
  });
}

bool LayeredDepth::share_space(std::span<const Layer> a, std::span<const Layer> b) {
  std::size_t i = 0, j = 0;
  const auto is_interval = [](std::span<const Layer> layers, std::size_t first) {
    return first + 1 < layers.size() && layers[first].pixel == layers[first + 1].pixel;
  };
  while (i < a.size() && j < b.size()) {
    if (!is_interval(a, i)) {
      ++i;  // the last of an odd number of layers
    } else if (!is_interval(b, j)) {
      ++j;
    } else if (a[i].pixel != b[j].pixel) {
      a[i].pixel < b[j].pixel ? i += 2 : j += 2;
    } else if (a[i + 1].depth < b[j].depth) {
      i += 2;
    } else if (b[j + 1].depth < a[i].depth) {
      j += 2;
    } else {
      return true;
    }
  }
  return false;
}

}  // namespace pelt::rivals
