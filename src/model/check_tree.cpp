#include "model/check_tree.hpp"

#include "model/clusters.hpp"
#include "model/unpack.hpp"
#include "model/weld.hpp"
#include "skin/palette.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pelt::detail {
namespace {

/// Allowed error of a sum of weights. Dividing weights by their sum leaves less: one rounding for
/// each influence, of at most 2^-24 of its weight.
constexpr double kNormalisedSumError = 0x1p-22;

constexpr std::uint32_t kNone = 0xFFFFFFFF;

class StructureCheck {
 public:
  explicit StructureCheck(const Tree& tree) : tree_(tree) {}

  /// Later checks rely on the earlier ones.
  Problem run() {
    for (const auto check :
         {&StructureCheck::check_sizes, &StructureCheck::check_influence_begin,
          &StructureCheck::check_vertices, &StructureCheck::check_nodes,
          &StructureCheck::check_clusters, &StructureCheck::check_pools,
          &StructureCheck::check_triangle_ids, &StructureCheck::check_vertex_places,
          &StructureCheck::check_place_vertices, &StructureCheck::check_offset_caps})
      if (Problem found = (this->*check)(); !found.empty()) return found;
    return check_pool_morphs(tree_);
  }

 private:
  Problem check_sizes();
  Problem check_influence_begin();
  Problem check_vertices();
  Problem check_influences(std::size_t vertex);
  bool is_behind_pivot(std::uint32_t first, std::uint32_t i) const;
  Problem check_nodes();
  Problem check_clusters();
  Problem check_pools();
  Problem check_cluster(std::uint32_t c);
  Problem check_triangle_ids();
  Problem check_vertex_places();
  Problem check_place_vertices();
  Problem check_offset_caps();

  std::uint32_t influence_count(std::uint32_t p) const {
    return tree_.influence_begin[p + 1] - tree_.influence_begin[p];
  }

  const Tree& tree_;
  // By vertex of one pool: the last cluster with the vertex in cluster_vertices, and in corners.
  std::vector<std::uint32_t> named_by_, used_by_;
};

Problem StructureCheck::check_sizes() {
  const std::size_t vertices = tree_.rest_positions.size();
  if (tree_.nodes.empty() || tree_.triangle_ids.empty())
    return problem("nodes or triangle_ids is empty");
  for (const std::size_t size :
       {vertices, tree_.joints.size(), tree_.triangle_ids.size(), tree_.cluster_vertices.size(),
        tree_.clusters.size(), tree_.nodes.size(), tree_.vertex_places.size()})
    if (size >= kNone) return problem("an array has %zu elements", size);
  if (tree_.influence_begin.size() != vertices + 1)
    return problem("influence_begin has %zu elements for %zu rest_positions",
                   tree_.influence_begin.size(), vertices);
  if (tree_.weights.size() != tree_.joints.size())
    return problem("weights has %zu elements for %zu joints", tree_.weights.size(),
                   tree_.joints.size());
  if (tree_.corners.size() != tree_.triangle_ids.size())
    return problem("corners has %zu elements for %zu triangle_ids", tree_.corners.size(),
                   tree_.triangle_ids.size());
  if (tree_.joint_count == 0 || tree_.joint_count > kMaxJoints)
    return problem("joint_count is %u, expected 1 to %u", tree_.joint_count, kMaxJoints);
  return {};
}

Problem StructureCheck::check_influence_begin() {
  const auto& begin = tree_.influence_begin;
  if (begin.front() != 0) return problem("influence_begin[0] is %u, expected 0", begin.front());
  for (std::size_t p = 0; p + 1 < begin.size(); ++p)
    if (begin[p] >= begin[p + 1]) return problem("rest_positions[%zu] has no influences", p);
  if (begin.back() != tree_.joints.size())
    return problem("influence_begin ends at %u, but there are %zu joints", begin.back(),
                   tree_.joints.size());
  return {};
}

Problem StructureCheck::check_vertices() {
  if (tree_.dual_influences > kMaxDualInfluences)
    return problem("dual_influences is %u, expected at most %u", tree_.dual_influences,
                   kMaxDualInfluences);
  Vec3 largest;
  for (std::size_t p = 0; p < tree_.rest_positions.size(); ++p) {
    const Vec3& v = tree_.rest_positions[p];
    for (const float c : {v.x, v.y, v.z})
      if (!(std::fabs(c) <= kMaxCoordinate))  // also true for NaN
        return problem("rest_positions[%zu] has the coordinate %g", p, static_cast<double>(c));
    largest = {std::max(largest.x, std::fabs(v.x)), std::max(largest.y, std::fabs(v.y)),
               std::max(largest.z, std::fabs(v.z))};
    if (Problem found = check_influences(p); !found.empty()) return found;
  }
  const double extent = double{largest.x} + double{largest.y} + double{largest.z};
  if (!(double{tree_.rest_extent} >= extent && tree_.rest_extent < kMaxExtent))
    return problem("rest_extent is %g, but rest_positions reach %g",
                   static_cast<double>(tree_.rest_extent), extent);
  return {};
}

/// Whether influence i has a smaller weight than the first, or the same and a higher joint.
bool StructureCheck::is_behind_pivot(std::uint32_t first, std::uint32_t i) const {
  return tree_.weights[i] < tree_.weights[first] ||
         (tree_.weights[i] == tree_.weights[first] && tree_.joints[i] > tree_.joints[first]);
}

Problem StructureCheck::check_influences(std::size_t vertex) {
  const std::uint32_t begin = tree_.influence_begin[vertex];
  const std::uint32_t end = tree_.influence_begin[vertex + 1];
  const bool is_dual = tree_.dual_influences > 0;
  if (is_dual && end - begin > tree_.dual_influences)
    return problem("vertex %zu has %u influences of %u", vertex, end - begin,
                   tree_.dual_influences);
  double sum = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    if (tree_.joints[i] >= tree_.joint_count)
      return problem("joints[%u] is %u, but joint_count is %u", i, tree_.joints[i],
                     tree_.joint_count);
    if (i > begin + is_dual && tree_.joints[i] <= tree_.joints[i - 1])
      return problem("joints[%u] of vertex %zu does not ascend", i, vertex);
    if (is_dual && i > begin && !is_behind_pivot(begin, i))
      return problem("joints[%u] of vertex %zu should be the first", i, vertex);
    if (!(tree_.weights[i] > 0))
      return problem("weights[%u] is %g", i, static_cast<double>(tree_.weights[i]));
    sum += double{tree_.weights[i]};
  }
  if (!(std::fabs(sum - 1) <= kNormalisedSumError) || (end - begin == 1 && sum != 1))
    return problem("weights of vertex %zu sum to %.9g", vertex, sum);
  return {};
}

/// Checks that the children, clusters and vertices of each node follow those of the node before, so
/// that each of them belongs to one node.
Problem StructureCheck::check_nodes() {
  std::size_t children = 1, clusters = 0, vertices = 0;
  std::vector<std::uint32_t> depths(tree_.nodes.size(), 1);
  for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
    const Node& node = tree_.nodes[n];
    const std::uint32_t slots = std::uint32_t{node.cluster_count} + node.child_count;
    if (slots == 0 || slots > kMaxSlots) return problem("nodes[%zu] has %u slots", n, slots);
    if (n == children) return problem("nodes[%zu] has no parent", n);
    if (node.first_child != children)
      return problem("nodes[%zu].first_child is %u, expected %zu", n, node.first_child, children);
    if (node.first_cluster != clusters)
      return problem("nodes[%zu].first_cluster is %u, expected %zu", n, node.first_cluster,
                     clusters);
    if (node.first_vertex != vertices)
      return problem("nodes[%zu].first_vertex is %u, expected %zu", n, node.first_vertex, vertices);
    if (depths[n] > kMaxClusterTreeDepth) return problem("nodes[%zu] is too deep", n);
    if (children + node.child_count > tree_.nodes.size())
      return problem("nodes[%zu] has children beyond the last node", n);
    std::fill_n(depths.begin() + children, node.child_count, depths[n] + 1);
    children += node.child_count;
    clusters += node.cluster_count;
    vertices += node.vertex_count;
  }
  if (clusters != tree_.clusters.size())
    return problem("nodes have %zu clusters of %zu", clusters, tree_.clusters.size());
  if (vertices > tree_.rest_positions.size())
    return problem("pools have %zu vertices, more than rest_positions", vertices);
  return {};
}

Problem StructureCheck::check_clusters() {
  std::size_t triangles = 0, vertices = 0;
  for (std::size_t c = 0; c < tree_.clusters.size(); ++c) {
    const Cluster& cluster = tree_.clusters[c];
    if (cluster.triangle_count == 0 || cluster.triangle_count > kMaxClusterTriangles)
      return problem("clusters[%zu] has %u triangles", c, cluster.triangle_count);
    if (cluster.first_triangle != triangles)
      return problem("clusters[%zu].first_triangle is %u, expected %zu", c, cluster.first_triangle,
                     triangles);
    if (cluster.first_vertex != vertices)
      return problem("clusters[%zu].first_vertex is %u, expected %zu", c, cluster.first_vertex,
                     vertices);
    triangles += cluster.triangle_count;
    vertices += cluster.listed_vertex_count();
  }
  if (triangles != tree_.triangle_ids.size())
    return problem("clusters have %zu triangles of %zu", triangles, tree_.triangle_ids.size());
  if (vertices != tree_.cluster_vertices.size())
    return problem("clusters have %zu vertices of %zu", vertices, tree_.cluster_vertices.size());
  return {};
}

Problem StructureCheck::check_pools() {
  for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
    const Node& node = tree_.nodes[n];
    named_by_.assign(node.vertex_count, kNone);
    used_by_.assign(node.vertex_count, kNone);
    for (std::uint32_t c = 0; c < node.cluster_count; ++c)
      if (Problem found = check_cluster(node.first_cluster + c); !found.empty()) return found;
    if (std::find(used_by_.begin(), used_by_.end(), kNone) != used_by_.end())
      return problem("a vertex in the pool of nodes[%zu] has no triangle", n);
    for (std::uint32_t p = node.first_vertex + 1; p < node.first_vertex + node.vertex_count; ++p)
      if (influence_count(p) < influence_count(p - 1))
        return problem("rest_positions[%u] has fewer influences than the one before it", p);
  }
  return {};
}

/// Checks that corners are offsets of vertices in the pool, and that `cluster_vertices` lists each
/// of them once.
Problem StructureCheck::check_cluster(std::uint32_t c) {
  const Cluster& cluster = tree_.clusters[c];
  for (std::uint32_t i = 0; i < cluster.vertex_count; ++i) {
    const std::uint16_t vertex = tree_.cluster_vertices[cluster.first_vertex + i];
    if (vertex % kFloatsPerVertex != 0 || vertex >= kFloatsPerVertex * named_by_.size() ||
        std::exchange(named_by_[vertex / kFloatsPerVertex], c) == c)
      return problem("cluster_vertices[%u] is %u, a duplicate or not in the pool",
                     cluster.first_vertex + i, vertex);
  }
  for (std::uint32_t i = cluster.vertex_count; i < cluster.listed_vertex_count(); ++i)
    if (tree_.cluster_vertices[cluster.first_vertex + i] !=
        tree_.cluster_vertices[cluster.first_vertex + cluster.vertex_count - 1])
      return problem("cluster_vertices[%u] does not repeat the last one", cluster.first_vertex + i);
  std::uint32_t used = 0;
  for (std::uint32_t i = 0; i < cluster.triangle_count; ++i)
    for (const std::uint16_t corner : tree_.corners[cluster.first_triangle + i]) {
      if (corner % kFloatsPerVertex != 0 || corner >= kFloatsPerVertex * named_by_.size() ||
          named_by_[corner / kFloatsPerVertex] != c)
        return problem("corners[%u] has %u, which is not one of its cluster_vertices",
                       cluster.first_triangle + i, corner);
      used += std::exchange(used_by_[corner / kFloatsPerVertex], c) != c;
    }
  if (used != cluster.vertex_count)
    return problem("clusters[%u] has %u vertices, but %u corners", c, cluster.vertex_count, used);
  return {};
}

Problem StructureCheck::check_triangle_ids() {
  std::vector<bool> seen(tree_.triangle_ids.size(), false);
  for (std::size_t t = 0; t < seen.size(); ++t) {
    const std::uint32_t id = tree_.triangle_ids[t];
    if (id >= seen.size()) return problem("triangle_ids[%zu] is %u of %zu", t, id, seen.size());
    if (seen[id]) return problem("triangle_ids[%zu] is %u, a repetition", t, id);
    seen[id] = true;
  }
  return {};
}

Problem StructureCheck::check_place_vertices() {
  if (tree_.place_vertices.size() != tree_.rest_positions.size())
    return problem("place_vertices has %zu elements for %zu rest_positions",
                   tree_.place_vertices.size(), tree_.rest_positions.size());
  for (std::size_t p = 0; p < tree_.place_vertices.size(); ++p)
    if (tree_.place_vertices[p] >= tree_.vertex_places.size())
      return problem("place_vertices[%zu] is %u, but there are %zu vertex_places", p,
                     tree_.place_vertices[p], tree_.vertex_places.size());
  return {};
}

Problem StructureCheck::check_offset_caps() {
  const std::vector<float>& caps = tree_.offset_caps;
  if (!caps.empty() && caps.size() != tree_.rest_positions.size())
    return problem("offset_caps has %zu elements for %zu rest_positions", caps.size(),
                   tree_.rest_positions.size());
  for (std::size_t p = 0; p < caps.size(); ++p)
    if (!(caps[p] >= 0 && caps[p] <= kMaxCoordinate))
      return problem("offset_caps[%zu] is %g", p, static_cast<double>(caps[p]));
  return {};
}

Problem StructureCheck::check_vertex_places() {
  for (std::size_t v = 0; v < tree_.vertex_places.size(); ++v)
    if (tree_.vertex_places[v] >= tree_.rest_positions.size())
      return problem("vertex_places[%zu] is %u, but there are %zu rest_positions", v,
                     tree_.vertex_places[v], tree_.rest_positions.size());
  return {};
}

/// Number of vertices in pools. The vertices that no triangle uses follow them.
std::size_t end_of_pools(const Tree& tree) {
  return std::size_t{tree.nodes.back().first_vertex} + tree.nodes.back().vertex_count;
}

/// Checks that no pool has a vertex of the caller twice, that vertices without triangles are in no
/// pool, and that each place has the bits of its vertex.
Problem check_vertices_of_places(const Tree& tree) {
  const std::vector<std::uint32_t> welded = weld_vertices(unpack_vertices(tree));
  std::vector<std::uint32_t> last_pool(tree.vertex_count(), kNone);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t i = 0; i < tree.nodes[n].vertex_count; ++i) {
      const std::uint32_t p = tree.nodes[n].first_vertex + i;
      if (std::exchange(last_pool[tree.place_vertices[p]], n) == n)
        return problem("rest_positions[%u] is twice in the pool of nodes[%u]", p, n);
    }
  for (std::size_t p = end_of_pools(tree); p < welded.size(); ++p)
    if (std::exchange(last_pool[tree.place_vertices[p]], 0u) != kNone)
      return problem("rest_positions[%zu] outside the pools is a duplicate", p);
  for (std::size_t p = 0; p < welded.size(); ++p)
    if (welded[p] != welded[tree.vertex_places[tree.place_vertices[p]]])
      return problem("rest_positions[%zu] is not that of vertex %u", p, tree.place_vertices[p]);
  return {};
}

}  // namespace

Problem check_structure(const Tree& tree) { return StructureCheck(tree).run(); }

Problem check_tree(const Tree& tree) {
  const Problem found = check_structure(tree);
  return found.empty() ? check_vertices_of_places(tree) : found;
}

}  // namespace pelt::detail
