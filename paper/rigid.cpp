#include "paper/rigid.hpp"

#include "paper/collide.hpp"
#include "skin/skin.hpp"

namespace pelt::paper {

QueryStats RigidBody::update(const Palette& palette) {
  detail::posed_vertices(mesh_, palette, positions_);
  tree_ = build_sphere_tree(positions_, mesh_.triangles);
  spheres_.clear();
  for (const Node& node : tree_.nodes) spheres_.push_back(make_ball(node.rest));
  QueryStats work;
  work.posed_vertices = positions_.size();
  return work;
}

QueryStats collide(const RigidBody& a, const RigidBody& b, Scratch& scratch,
                   std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  const PosedSide side_a = a.side(), side_b = b.side();
  return descend(side_a, side_b, scratch, contacts, max_contacts);
}

}  // namespace pelt::paper
