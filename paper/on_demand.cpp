#include "paper/on_demand.hpp"

#include "paper/leaf_order.hpp"

namespace pelt::paper {

SphereModel build_sphere_model(const SkinnedMesh& mesh, BoundKind kind, float collapse_ratio) {
  SphereModel model;
  model.tree = build_sphere_tree(mesh.rest_positions, mesh.triangles, collapse_ratio);
  model.bounds = build_weight_bounds(mesh, model.tree, kind);
  model.records = RefitRecords(model.tree, model.bounds);
  model.leaf_mesh = in_leaf_order(mesh, model.tree);
  return model;
}

QueryStats collide(OnDemandBody& a, const Palette& palette_a, OnDemandBody& b,
                   const Palette& palette_b, Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts) {
  const std::uint64_t refits = a.refits() + b.refits();
  const std::uint64_t posed_vertices = a.posed_vertices() + b.posed_vertices();
  OnDemandBody::Side side_a(a, palette_a), side_b(b, palette_b);
  QueryStats stats = descend(side_a, side_b, scratch, contacts, max_contacts);
  stats.refits = a.refits() + b.refits() - refits;
  stats.posed_vertices = a.posed_vertices() + b.posed_vertices() - posed_vertices;
  return stats;
}

}  // namespace pelt::paper
