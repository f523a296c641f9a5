/// Compares the boxes of all nodes with the vertices below them.

#include <pelt/pose.hpp>

#include "base/problem.hpp"
#include "model/unpack.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "skin/skin.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace pelt {
namespace {

using detail::Cluster;
using detail::Node;
using detail::OpenedNode;
using detail::Problem;
using detail::Tree;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Exact box of vertices.
struct Box {
  std::array<float, 3> low = {kInfinity, kInfinity, kInfinity};
  std::array<float, 3> high = {-kInfinity, -kInfinity, -kInfinity};

  void include(const Vec3& p) { include(Box{{p.x, p.y, p.z}, {p.x, p.y, p.z}}); }

  void include(const Box& other) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], other.low[a]);
      high[a] = std::max(high[a], other.high[a]);
    }
  }
};

/// Returns the caller's offsets in the order of the pools, or none.
std::vector<Vec3> offsets_by_place(const Tree& tree, const detail::Palette& palette) {
  std::vector<Vec3> offsets;
  if (!palette.offsets().empty())
    for (const std::uint32_t v : tree.place_vertices) offsets.push_back(palette.offsets()[v]);
  return offsets;
}

/// Poses all vertices by the definition, or copies the given ones.
std::vector<Vec3> pose_all(const Tree& tree, const detail::Pose& pose) {
  const detail::SkinnedMesh mesh = detail::unpack_vertices(tree);
  const std::vector<Vec3> offsets = offsets_by_place(tree, pose.palette);
  detail::Palette palette = pose.palette;
  palette.set_offsets(offsets);
  std::vector<Vec3> posed(tree.rest_positions.size());
  for (std::uint32_t v = 0; v < posed.size(); ++v)
    posed[v] = pose.given ? pose.given.vertex(v) : scalar::posed_vertex(mesh, palette, v);
  return posed;
}

/// Returns for each node the box of the vertices of all pools below it.
std::vector<Box> boxes_below(const Tree& tree, const std::vector<Vec3>& posed) {
  std::vector<Box> boxes(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const Node& node = tree.nodes[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v)
      boxes[n].include(posed[node.first_vertex + v]);
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      boxes[n].include(boxes[node.first_child + c]);
  }
  return boxes;
}

Problem left_out(std::uint32_t node, const char* bound, std::uint32_t number, std::size_t axis,
                 float distance) {
  return detail::problem("node %u: the box of %s %u misses a vertex by %g along %c", node, bound,
                         number, static_cast<double>(distance), "xyz"[axis]);
}

/// Compares the bounds of one instance with its posed vertices.
class BoundsCheck {
 public:
  BoundsCheck(const Tree& tree, const std::vector<Vec3>& posed)
      : tree_(tree), posed_(posed), below_(boxes_below(tree, posed)) {}

  /// Checks all bounds that have been computed.
  Problem run(const detail::Pose& pose) {
    node_ = 0;
    const detail::RootBox& root = pose.root_box;
    if (root.known) expect(box_of(root.low, root.high), below_[0], "the root", 0);
    if (!pose.opened) return problem_;  // no query has opened a node
    for (; node_ < tree_.nodes.size() && problem_.empty(); ++node_)
      if (const OpenedNode* node = pose.opened[node_]) check(*node);
    return problem_;
  }

 private:
  static Box box_of(const float (&low)[4], const float (&high)[4]) {
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  }

  template <std::size_t kCount>
  static Box lane(const float (&low)[3][kCount], const float (&high)[3][kCount],
                  std::uint32_t lane) {
    return {{low[0][lane], low[1][lane], low[2][lane]},
            {high[0][lane], high[1][lane], high[2][lane]}};
  }

  /// Also detects bounds that are NaN.
  void expect(const Box& bound, const Box& exact, const char* name, std::uint32_t number) {
    for (std::size_t a = 0; a < 3 && problem_.empty(); ++a) {
      if (!(bound.low[a] <= exact.low[a]))
        problem_ = left_out(node_, name, number, a, bound.low[a] - exact.low[a]);
      else if (!(exact.high[a] <= bound.high[a]))
        problem_ = left_out(node_, name, number, a, exact.high[a] - bound.high[a]);
    }
  }

  void check(const OpenedNode& opened) {
    const Node& node = tree_.nodes[node_];
    expect(box_of(opened.all_low, opened.all_high), below_[node_], "all slots of node", node_);
    for (std::uint32_t c = 0; c < node.cluster_count; ++c) check_cluster(opened, node, c);
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      expect(lane(opened.low, opened.high, node.cluster_count + c), below_[node.first_child + c],
             "child", node.first_child + c);
  }

  void check_cluster(const OpenedNode& opened, const Node& node, std::uint32_t slot) {
    const Cluster& cluster = tree_.clusters[node.first_cluster + slot];
    const detail::TriangleBoxes* boxes = opened.triangles[slot].load(std::memory_order_acquire);
    Box all;
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
      Box exact;
      for (const std::uint16_t corner : tree_.corners[cluster.first_triangle + i])
        exact.include(posed_[node.first_vertex + corner / detail::kFloatsPerVertex]);
      if (boxes)
        expect(lane(boxes->low, boxes->high, i), exact, "triangle",
               tree_.triangle_ids[cluster.first_triangle + i]);
      all.include(exact);
    }
    expect(lane(opened.low, opened.high, slot), all, "cluster", node.first_cluster + slot);
  }

  const Tree& tree_;
  const std::vector<Vec3>& posed_;
  std::vector<Box> below_;
  std::uint32_t node_ = 0;
  Problem problem_;
};

}  // namespace

std::string check_bounds(const Pose& pose) {
  const detail::Pose& data = pose.detail();
  const Tree& tree = data.model.detail().tree;
  const std::vector<Vec3> posed = pose_all(tree, data);
  BoundsCheck check(tree, posed);
  if (Problem problem = check.run(data); !problem.empty())
    return problem + ", in a pose that queries have opened";

  Pose fresh(data.model);
  fresh.detail().palette = data.palette;
  fresh.detail().given = data.given;
  const detail::PosedTree posed_tree = fresh.detail().posed_tree();
  make_table(posed_tree);
  detail::compute_all_bounds(posed_tree);
  return check.run(fresh.detail());
}

}  // namespace pelt
