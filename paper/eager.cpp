#include "paper/eager.hpp"

#include "paper/collide.hpp"
#include "paper/triangle_balls.hpp"
#include "skin/skin.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::paper {
namespace {

/// A tight ball around balls; its centre is the centre of the box around them.
Float4 ball_of_balls(std::span<const Float4> balls) {
  Float4 low = balls[0] - Float4(balls[0][3]), high = balls[0] + Float4(balls[0][3]);
  for (const Float4& ball : balls.subspan(1)) {
    low = detail::min(low, ball - Float4(ball[3]));
    high = detail::max(high, ball + Float4(ball[3]));
  }
  const Float4 centre = 0.5f * (low + high);
  float radius = 0;
  for (const Float4& ball : balls)
    radius = std::max(radius, std::sqrt(squared_distance(ball, centre)) + ball[3]);
  return make_ball(centre, radius);
}

}  // namespace

EagerBody::EagerBody(const SkinnedMesh& mesh, const SphereTree& tree)
    : mesh_(mesh), tree_(tree), positions_(mesh.vertex_count() + 1), spheres_(tree.nodes.size()) {
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    if (node.is_leaf())
      leaves_.push_back({n, mesh.triangles[tree.triangle_of_leaf(node)]});
    else
      inner_nodes_.push_back(n);
  }
}

QueryStats EagerBody::update(const Palette& palette) {
  skin(palette);
  refit_bottom_up();
  QueryStats work;
  work.posed_vertices = mesh_.vertex_count();
  work.refits = spheres_.size();
  return work;
}

void EagerBody::skin(const Palette& palette) {
  detail::posed_vertices(mesh_, palette, positions());
}

void EagerBody::refit_bottom_up() {
  refit_leaves();
  for (std::size_t i = inner_nodes_.size(); i-- > 0;) {  // children stand after their parents
    const Node& node = tree_.nodes[inner_nodes_[i]];
    spheres_[inner_nodes_[i]] =
        ball_of_balls({spheres_.data() + node.first_child, node.child_count});
  }
}

/// Four leaves at a time. If the number of leaves is not a multiple of four, the last step repeats
/// some.
void EagerBody::refit_leaves() {
  const std::size_t count = leaves_.size();
  for (std::size_t first = 0; first < count; first += 4) {
    std::array<std::size_t, 4> leaf;
    for (std::size_t i = 0; i < 4; ++i) leaf[i] = std::min(first + i, count - 1);
    const auto corner = [&](std::size_t k) {
      const auto load = [&](std::size_t i) {
        return detail::load4(&positions_[leaves_[leaf[i]].corners[k]].x);
      };
      return side_by_side(load(0), load(1), load(2), load(3));
    };
    const std::array<Float4, 4> balls = triangle_balls(corner(0), corner(1), corner(2));
    for (std::size_t i = 0; i < 4; ++i)
      spheres_[leaves_[leaf[i]].node] = make_ball(balls[i], balls[i][3]);
  }
}

QueryStats collide(const EagerBody& a, const EagerBody& b, Scratch& scratch,
                   std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  const PosedSide side_a = a.side(), side_b = b.side();
  return descend(side_a, side_b, scratch, contacts, max_contacts);
}

}  // namespace pelt::paper
