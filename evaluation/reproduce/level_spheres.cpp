#include "evaluation/reproduce/level_spheres.hpp"

#include <limits>

namespace pelt::reproduce {

using detail::Palette;
using paper::Float4;

std::vector<std::uint32_t> nodes_on_level(const paper::SphereTree& tree, std::uint32_t level) {
  std::vector<std::uint32_t> nodes = {0};
  for (std::uint32_t l = 1; l < level; ++l) {
    std::vector<std::uint32_t> below;
    for (const std::uint32_t n : nodes)
      for (std::uint32_t c = 0; c < tree.nodes[n].child_count; ++c)
        below.push_back(tree.nodes[n].first_child + c);
    nodes = std::move(below);
  }
  return nodes;
}

std::vector<Float4> all_refitted(const paper::SphereModel& model, const Palette& palette) {
  paper::Refit refit(model, static_cast<std::uint32_t>(palette.joints().size()));
  std::vector<Float4> spheres;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
    spheres.push_back(refit.sphere(n, palette));
  return spheres;
}

AskedPair ask_on_demand(const detail::SkinnedMesh& mesh, const paper::SphereModel& model,
                        const std::array<Palette, 2>& palettes) {
  std::array<paper::OnDemandBody, 2> bodies = {paper::OnDemandBody(mesh, model),
                                               paper::OnDemandBody(mesh, model)};
  paper::Scratch scratch;
  std::vector<Contact> contacts;
  AskedPair pair;
  pair.work = collide(bodies[0], palettes[0], bodies[1], palettes[1], scratch, contacts,
                      std::numeric_limits<std::uint32_t>::max());
  for (std::size_t i = 0; i < 2; ++i) {
    pair.bodies[i].spheres = all_refitted(model, palettes[i]);
    for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
      pair.bodies[i].refitted.push_back(!bodies[i].is_stale(n));
  }
  return pair;
}

}  // namespace pelt::reproduce
