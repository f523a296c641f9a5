#include "model/surface.hpp"

#include "base/disjoint_sets.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <utility>

namespace pelt {
namespace detail {
namespace {

/// Returns the first triangle of each component that is connected by shared vertices.
std::vector<std::uint32_t> find_components(const std::vector<Triangle>& triangles,
                                           std::uint32_t vertex_count) {
  std::vector<std::uint32_t> memory;
  DisjointSets sets(vertex_count, memory);
  for (const Triangle& t : triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<std::uint32_t> firsts;
  std::vector<bool> is_known(vertex_count, false);
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
    const std::uint32_t set = sets.find(triangles[triangle][0]);
    if (!is_known[set]) firsts.push_back(triangle);
    is_known[set] = true;
  }
  return firsts;
}

/// Whether each directed edge and its opposite occur exactly once. Ignores triangles with a
/// repeated vertex: they have no area in any pose, and their edges cancel each other.
bool edges_pair_up(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> forward, backward;
  for (const Triangle& t : triangles) {
    if (has_repeated_vertex(t)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      forward.emplace_back(t[i], t[(i + 1) % 3]);
      backward.emplace_back(t[(i + 1) % 3], t[i]);
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  const bool is_once = std::adjacent_find(forward.begin(), forward.end()) == forward.end();
  return is_once && !forward.empty() && forward == backward;
}

}  // namespace

Surface::Surface(const Model& m) : model(m) {
  SkinnedMesh mesh = unpack_mesh(model.tree);
  joints = main_joints(mesh);
  components = find_components(mesh.triangles, mesh.vertex_count());
  corners = std::move(mesh.triangles);
  is_closed = edges_pair_up(corners);
}

const Surface& Model::surface() const {
  return lazy_surface.get([this] { return std::make_shared<const Surface>(*this); });
}

}  // namespace detail

Surface::Surface(std::shared_ptr<const detail::Surface> surface) : surface_(std::move(surface)) {}

bool Surface::is_closed() const { return surface_->is_closed; }

Surface SkinnedModel::surface() const {
  return Surface(std::shared_ptr<const detail::Surface>(model_, &model_->surface()));
}

}  // namespace pelt
