#include "skin/skinned_mesh.hpp"

#include "base/problem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Validates the morph targets and copies their nonzero displacements into the mesh. Precondition:
/// the mesh has its rest positions. O(V + M + D).
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

/// Sums of weights farther from 1 are more than rounding by an exporter.
constexpr double kExporterRounding = 0x1p-7;

/// Sums of weights nearer to 1 are rounding of floats and are not reported.
constexpr double kFloatRounding = 0x1p-16;

Problem check_no_joints(const SkinnedMeshView& view) {
  if (view.joints.empty() && view.weights.empty()) return {};
  return problem("joint_count is 0, but joints has %zu and weights has %zu elements",
                 view.joints.size(), view.weights.size());
}

Problem check_influence_sizes(const SkinnedMeshView& view) {
  if (view.influences_per_vertex == 0) return problem("influences_per_vertex is 0");
  if (view.joint_count > kMaxJoints)
    return problem("joint_count is %u, expected 0 to %u", view.joint_count, kMaxJoints);
  const std::uint64_t expected =
      std::uint64_t{view.rest_positions.size()} * view.influences_per_vertex;
  if (expected > 0xFFFFFFFF)
    return problem("rest_positions x influences_per_vertex is more than 2^32 - 1");
  if (view.joints.size() != expected || view.weights.size() != expected)
    return problem(
        "joints has %zu and weights has %zu elements, expected %zu "
        "(rest_positions x influences_per_vertex)",
        view.joints.size(), view.weights.size(), static_cast<std::size_t>(expected));
  return {};
}

Problem check_sizes(const SkinnedMeshView& view) {
  if (view.rest_positions.size() > 0x7FFFFFFF || view.triangles.size() > 0x7FFFFFFF)
    return problem("rest_positions or triangles have more than 2^31 - 1 elements");
  if (view.triangles.empty()) return problem("triangles is empty");
  return view.joint_count == 0 ? check_no_joints(view) : check_influence_sizes(view);
}

Problem check_rest_positions(std::span<const Vec3> rest_positions) {
  for (std::size_t v = 0; v < rest_positions.size(); ++v) {
    const Vec3& p = rest_positions[v];
    for (const float c : {p.x, p.y, p.z})
      if (!(std::fabs(c) <= kMaxCoordinate))  // also true for NaN
        return problem("rest_positions[%zu] has the coordinate %g, expected finite and within 2^60",
                       v, static_cast<double>(c));
  }
  return {};
}

Problem check_triangles(std::span<const Triangle> triangles, std::size_t vertex_count) {
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t v : triangles[t])
      if (v >= vertex_count)
        return problem("triangles[%zu] refers to vertex %u, but there are %zu rest_positions", t, v,
                       vertex_count);
  return {};
}

Problem check_influence(const SkinnedMeshView& view, std::size_t vertex, std::size_t slot) {
  const std::size_t i = vertex * view.influences_per_vertex + slot;
  if (view.joints[i] >= view.joint_count)
    return problem("joints[%zu] of vertex %zu is %u, but joint_count is %u", i, vertex,
                   view.joints[i], view.joint_count);
  if (!(view.weights[i] >= 0 && std::isfinite(view.weights[i])))
    return problem("weights[%zu] of vertex %zu is %g, expected a finite number >= 0", i, vertex,
                   static_cast<double>(view.weights[i]));
  return {};
}

/// Replaces the content of `merged` with the influences of one vertex: without zero weights, with
/// the weights of a repeated joint summed, and with joints in ascending order.
void merge_influences(const SkinnedMeshView& view, std::size_t vertex,
                      std::vector<Influence>& merged, BuildReport& report) {
  merged.clear();
  const std::size_t begin = vertex * view.influences_per_vertex;
  for (std::size_t i = begin; i < begin + view.influences_per_vertex; ++i)
    if (view.weights[i] > 0) merged.push_back(Influence{view.joints[i], view.weights[i]});
  std::stable_sort(merged.begin(), merged.end(),
                   [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < merged.size(); ++i) {
    if (kept > 0 && merged[kept - 1].joint == merged[i].joint) {
      merged[kept - 1].weight += merged[i].weight;
      ++report.merged_influences;
    } else {
      merged[kept++] = merged[i];
    }
  }
  merged.resize(kept);
}

/// Divides the weights by their sum.
Problem normalise_weights(std::span<Influence> influences, std::size_t vertex,
                          const ModelOptions& options, BuildReport& report) {
  double sum = 0;
  for (const Influence& influence : influences) sum += static_cast<double>(influence.weight);
  if (!(sum > 0 && std::isfinite(sum)))  // weights of one joint may sum to infinity
    return problem("weights of vertex %zu sum to %g, expected 1", vertex, sum);
  const double error = std::fabs(sum - 1);
  if (error > kExporterRounding && options.off_weights == OffWeights::refuse)
    return problem(
        "weights of vertex %zu sum to %.6g, expected 1 (off_weights = OffWeights::renormalise "
        "divides by the sum)",
        vertex, sum);
  if (error > kFloatRounding) ++report.renormalised_vertices;
  for (Influence& influence : influences)
    influence.weight = static_cast<float>(static_cast<double>(influence.weight) / sum);
  return {};
}

/// Moves the influence with the largest weight to the front; of equal weights, the first.
Problem put_pivot_first(std::span<Influence> influences, std::size_t vertex, SkinnedMesh& mesh) {
  if (influences.size() > kMaxDualInfluences)
    return problem("vertex %zu follows %zu joints, but dual quaternion skinning allows %u", vertex,
                   influences.size(), kMaxDualInfluences);
  const auto less = [](const Influence& a, const Influence& b) { return a.weight < b.weight; };
  const auto pivot = std::max_element(influences.begin(), influences.end(), less);
  std::rotate(influences.begin(), pivot, pivot + 1);
  mesh.dual_influences =
      std::max(mesh.dual_influences, static_cast<std::uint32_t>(influences.size()));
  return {};
}

Problem take_influences(const SkinnedMeshView& view, const ModelOptions& options, SkinnedMesh& mesh,
                        BuildReport& report) {
  mesh.influence_begin.reserve(view.rest_positions.size() + 1);
  mesh.influence_begin.push_back(0);
  std::vector<Influence> merged;
  for (std::size_t v = 0; v < view.rest_positions.size(); ++v) {
    for (std::size_t slot = 0; slot < view.influences_per_vertex; ++slot)
      if (Problem found = check_influence(view, v, slot); !found.empty()) return found;
    merge_influences(view, v, merged, report);
    if (Problem found = normalise_weights(merged, v, options, report); !found.empty()) return found;
    // The division can turn a tiny weight into zero.
    for (const Influence& influence : merged)
      if (influence.weight > 0) mesh.influences.push_back(influence);
    mesh.influence_begin.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
    if (options.skinning == Skinning::linear) continue;
    const std::span<Influence> all(mesh.influences);
    if (Problem found = put_pivot_first(all.subspan(mesh.influence_begin[v]), v, mesh);
        !found.empty())
      return found;
  }
  return {};
}

Problem take_offset_caps(std::span<const float> caps, SkinnedMesh& mesh) {
  if (!caps.empty() && caps.size() != mesh.rest_positions.size())
    return problem("offset_caps has %zu elements for %zu rest_positions", caps.size(),
                   mesh.rest_positions.size());
  for (std::size_t v = 0; v < caps.size(); ++v) {
    if (!(caps[v] >= 0 && caps[v] <= kMaxCoordinate))
      return problem("offset_caps[%zu] is %g, expected 0 to 2^60", v, static_cast<double>(caps[v]));
    mesh.offset_caps.push_back(caps[v] + 0.0f);  // makes -0 positive
  }
  return {};
}

/// Lets all vertices follow one joint.
void add_one_joint(SkinnedMesh& mesh) {
  mesh.joint_count = 1;
  mesh.influences.assign(mesh.vertex_count(), Influence{0, 1});
  mesh.influence_begin.resize(mesh.rest_positions.size() + 1);
  std::iota(mesh.influence_begin.begin(), mesh.influence_begin.end(), 0u);
}

std::uint32_t count_degenerate(const SkinnedMesh& mesh) {
  std::uint32_t count = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3& a = mesh.rest_positions[triangle[0]];
    const Vec3& b = mesh.rest_positions[triangle[1]];
    const Vec3& c = mesh.rest_positions[triangle[2]];
    count += a == b || b == c || c == a;
  }
  return count;
}

}  // namespace

Result<SkinnedMesh> make_skinned_mesh(const SkinnedMeshView& view, const ModelOptions& options,
                                      BuildReport& report) {
  Problem found = check_sizes(view);
  if (found.empty()) found = check_rest_positions(view.rest_positions);
  if (found.empty()) found = check_triangles(view.triangles, view.rest_positions.size());
  if (!found.empty()) return invalid_argument(found);

  SkinnedMesh mesh;
  mesh.rest_positions.assign(view.rest_positions.begin(), view.rest_positions.end());
  mesh.triangles.assign(view.triangles.begin(), view.triangles.end());
  mesh.joint_count = view.joint_count;
  mesh.may_weld = options.weld;
  mesh.rest_extent = extent_of(mesh.rest_positions);
  if (view.joint_count == 0)
    add_one_joint(mesh);
  else
    found = take_influences(view, options, mesh, report);
  if (found.empty()) found = take_morph_targets(view.morph_targets, mesh);
  if (found.empty()) found = take_offset_caps(view.offset_caps, mesh);
  if (!found.empty()) return invalid_argument(found);
  report.degenerate_triangles = count_degenerate(mesh);
  return mesh;
}

namespace {

/// `sums` is working memory of the caller.
std::uint32_t main_joint(const SkinnedMesh& mesh, const Triangle& corners,
                         std::vector<Influence>& sums) {
  sums.clear();
  for (const std::uint32_t vertex : corners)
    for (const Influence& influence : mesh.influences_of(vertex)) {
      const auto same = [&](const Influence& sum) { return sum.joint == influence.joint; };
      const auto known = std::find_if(sums.begin(), sums.end(), same);
      if (known == sums.end())
        sums.push_back(influence);
      else
        known->weight += influence.weight;
    }
  const auto less = [](const Influence& a, const Influence& b) {
    return a.weight < b.weight || (a.weight == b.weight && a.joint > b.joint);
  };
  return std::max_element(sums.begin(), sums.end(), less)->joint;
}

}  // namespace

std::vector<std::uint16_t> main_joints(const SkinnedMesh& mesh) {
  std::vector<std::uint16_t> joints;
  joints.reserve(mesh.triangles.size());
  std::vector<Influence> sums;
  for (const Triangle& triangle : mesh.triangles)
    joints.push_back(static_cast<std::uint16_t>(main_joint(mesh, triangle, sums)));
  return joints;
}

}  // namespace pelt::detail
