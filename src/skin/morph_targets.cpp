#include "skin/morph_targets.hpp"

#include "skin/extent.hpp"

#include <cmath>

namespace pelt::detail {
namespace {

Problem check_sizes(const MorphTargetsView& view) {
  const std::size_t count = view.vertices.size();
  if (view.displacements.size() != count)
    return problem("morph_targets.displacements has %zu elements, but vertices has %zu",
                   view.displacements.size(), count);
  if (count >= 0xFFFFFFFF) return problem("morph_targets.vertices has more than 2^32 - 2 elements");
  if (view.begin.empty())
    return count == 0 ? Problem() : problem("morph_targets.begin is empty, but vertices is not");
  if (view.begin.size() - 1 > kMaxMorphTargets)
    return problem("there are %zu morph targets, expected at most %u", view.begin.size() - 1,
                   kMaxMorphTargets);
  if (view.begin.front() != 0 || view.begin.back() != count)
    return problem("morph_targets.begin goes from %u to %u, expected 0 to %zu", view.begin.front(),
                   view.begin.back(), count);
  for (std::size_t m = 0; m + 1 < view.begin.size(); ++m)
    if (view.begin[m] > view.begin[m + 1])
      return problem("morph_targets.begin[%zu] is %u, less than the one before it", m + 1,
                     view.begin[m + 1]);
  return {};
}

Problem check_target(const MorphTargetsView& view, std::size_t target, std::size_t vertex_count) {
  for (std::size_t i = view.begin[target]; i < view.begin[target + 1]; ++i) {
    if (view.vertices[i] >= vertex_count)
      return problem("morph_targets.vertices[%zu] of target %zu is %u of %zu", i, target,
                     view.vertices[i], vertex_count);
    if (i > view.begin[target] && view.vertices[i] <= view.vertices[i - 1])
      return problem("morph_targets.vertices[%zu] of target %zu is %u, which does not ascend", i,
                     target, view.vertices[i]);
    const Vec3& d = view.displacements[i];
    for (const float c : {d.x, d.y, d.z})
      if (!(std::fabs(c) <= kMaxCoordinate))  // also true for NaN
        return problem(
            "morph_targets.displacements[%zu] of target %zu has the coordinate %g, expected finite "
            "and within 2^60",
            i, target, static_cast<double>(c));
  }
  return {};
}

/// Sorts displacements by vertex instead of by target: one pass counts, one moves.
void sort_by_vertex(const MorphTargetsView& view, SkinnedMesh& mesh) {
  auto& begin = mesh.displacement_begin;
  begin.assign(mesh.rest_positions.size() + 1, 0);
  const auto moves = [&](std::size_t i) { return !(view.displacements[i] == Vec3()); };
  for (std::size_t i = 0; i < view.vertices.size(); ++i) begin[view.vertices[i] + 1] += moves(i);
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  mesh.displacements.resize(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t m = 0; m < mesh.morph_extents.size(); ++m)
    for (std::size_t i = view.begin[m]; i < view.begin[m + 1]; ++i)
      if (moves(i)) mesh.displacements[next[view.vertices[i]]++] = {m, view.displacements[i]};
}

}  // namespace

Problem take_morph_targets(const MorphTargetsView& view, SkinnedMesh& mesh) {
  if (Problem found = check_sizes(view); !found.empty()) return found;
  for (std::size_t m = 0; m + 1 < view.begin.size(); ++m) {
    if (Problem found = check_target(view, m, mesh.rest_positions.size()); !found.empty())
      return found;
    mesh.morph_extents.push_back(
        extent_of(view.displacements.subspan(view.begin[m], view.begin[m + 1] - view.begin[m])));
  }
  if (!mesh.morph_extents.empty()) sort_by_vertex(view, mesh);
  return {};
}

}  // namespace pelt::detail
