#include "paper/eager.hpp"

#include "geometry/min_sphere.hpp"
#include "paper/collide.hpp"
#include "pose/skin.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::paper {
namespace {

/// A tight ball around balls: from the middle of the box around them, a few steps towards the ball
/// that reaches farthest out (Badoiu & Clarkson 2003).
Float4 ball_of_balls(std::span<const Float4> balls) {
  Float4 low = balls[0] - Float4(balls[0][3]), high = balls[0] + Float4(balls[0][3]);
  for (const Float4& ball : balls.subspan(1)) {
    low = detail::min(low, ball - Float4(ball[3]));
    high = detail::max(high, ball + Float4(ball[3]));
  }
  Float4 centre = 0.5f * (low + high);
  float radius = 0;
  for (const Float4& ball : balls)
    radius = std::max(radius, std::sqrt(squared_distance(ball, centre)) + ball[3]);
  return make_ball(centre, radius);
}

}  // namespace

EagerBody::EagerBody(const SkinnedMesh& mesh, const SphereTree& tree)
    : mesh_(mesh),
      tree_(tree),
      positions_(mesh.vertex_count()),
      spheres_(tree.nodes.size()) {}

QueryStats EagerBody::update(const Palette& palette) {
  skin(palette);
  refit_bottom_up();
  QueryStats work;
  work.posed_vertices = positions_.size();
  work.refits = spheres_.size();
  return work;
}

void EagerBody::skin(const Palette& palette) {
  detail::posed_vertices(mesh_, palette, positions_);
}

void EagerBody::refit_bottom_up() {
  for (std::size_t n = tree_.nodes.size(); n-- > 0;) {  // children stand after their parents
    const Node& node = tree_.nodes[n];
    if (node.is_leaf())
      spheres_[n] =
          make_ball(detail::ball_of_triangle(side().triangle(tree_.triangle_of_leaf(node))));
    else
      spheres_[n] = ball_of_balls({spheres_.data() + node.first_child, node.child_count});
  }
}

QueryStats collide(const EagerBody& a, const EagerBody& b, Scratch& scratch,
                   std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  const PosedSide side_a = a.side(), side_b = b.side();
  return descend(side_a, side_b, scratch, contacts, max_contacts);
}

}  // namespace pelt::paper
