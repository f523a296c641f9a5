#include "model/surface.hpp"

#include "base/disjoint_sets.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "skin/main_joint.hpp"

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

Surface::Surface(const SkinnedModel& m) : model(m) {
  SkinnedMesh mesh = unpack_mesh(model.detail().tree);
  joints = main_joints(mesh);
  components = find_components(mesh.triangles, mesh.vertex_count());
  corners = std::move(mesh.triangles);
  is_closed = edges_pair_up(corners);
}

}  // namespace detail

Surface::Surface(const SkinnedModel& model)
    : surface_(std::make_shared<const detail::Surface>(model)) {}

bool Surface::is_closed() const { return surface_->is_closed; }
const SkinnedModel& Surface::model() const { return surface_->model; }

}  // namespace pelt
