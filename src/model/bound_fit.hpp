#pragma once

/// Fits the coefficients of one node's bound to its rest vertices, in double precision
/// (node_bounds.hpp), and what the bound adds with dual quaternion skinning.

#include "base/vec3.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "skin/joint_link.hpp"
#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// The vertices of all pools below a node, and the joints that move them.
class NodeVertices {
 public:
  explicit NodeVertices(const Tree& tree) : tree_(tree), number_(tree.joint_count) {}

  /// Replaces the content with the vertices of a node, given by their positions in the pools.
  void assign(std::span<const std::uint32_t> places) {
    places_ = places;
    joints_.clear();
    for (const std::uint32_t place : places)
      for (std::uint32_t i = tree_.influence_begin[place]; i < tree_.influence_begin[place + 1];
           ++i)
        joints_.push_back(tree_.joints[i]);
    std::sort(joints_.begin(), joints_.end());
    joints_.erase(std::unique(joints_.begin(), joints_.end()), joints_.end());
    for (std::size_t i = 0; i < joints_.size(); ++i)
      number_[joints_[i]] = static_cast<std::uint32_t>(i);
  }

  std::span<const std::uint32_t> places() const { return places_; }
  std::span<const std::uint16_t> joints() const { return joints_; }  ///< ascending
  float rest_extent() const { return tree_.rest_extent; }            ///< of the whole mesh
  bool is_dual() const { return tree_.dual_influences > 0; }
  std::span<const JointLink> links() const { return tree_.links; }
  Vec3d position(std::uint32_t place) const { return Vec3d(tree_.rest_positions[place]); }

  /// Calls `visit(i, weight)` for each influence, whose joint is joints()[i].
  template <typename Visit>
  void each_weight(std::uint32_t place, const Visit& visit) const {
    for (std::uint32_t i = tree_.influence_begin[place]; i < tree_.influence_begin[place + 1]; ++i)
      visit(number_[tree_.joints[i]], static_cast<double>(tree_.weights[i]));
  }

 private:
  const Tree& tree_;
  std::span<const std::uint32_t> places_;
  std::vector<std::uint16_t> joints_;
  std::vector<std::uint32_t> number_;  // by joint: its index in joints_
};

/// Calls `visit(node, places)` for every node with the positions in the pools of all vertices below
/// the node. Children are visited before their parents.
template <typename Visit>
void each_subtree(const Tree& tree, const Visit& visit) {
  std::vector<std::vector<std::uint32_t>> places(tree.nodes.size());
  for (auto n = static_cast<std::uint32_t>(tree.nodes.size()); n-- > 0;) {
    const Node& node = tree.nodes[n];
    std::vector<std::uint32_t>& below = places[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v) below.push_back(node.first_vertex + v);
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
      below.insert(below.end(), places[c].begin(), places[c].end());
      places[c] = {};
    }
    visit(n, std::span<const std::uint32_t>(below));
  }
}

/// Properties of the whole mesh that the margins depend on.
struct WeightRounding {
  double influences = 0;  ///< largest number of a vertex
  double sum_error = 0;   ///< largest error of a vertex's sum of weights
  double rest_extent = 0;
};

WeightRounding weight_rounding(const Tree& tree);

struct JointBoxesFit {
  std::vector<JointBox> boxes;  // one for each joint of the node
  float margin = 0;
};

JointBoxesFit fit_joint_boxes(const NodeVertices& vertices, const WeightRounding& rounding);

struct AffineFit {
  RestShape shape;
  std::vector<std::uint16_t> joints;  // of the node, the reference first
  std::vector<JointFit> fits;         // one for each of the others
  float margin = 0;
};

AffineFit fit_affine(const NodeVertices& vertices, const WeightRounding& rounding);

/// Computes the boxes of the displacements of each rest body's vertices. Call `add` for the
/// vertices of each bound, in any order, and then `finish` once.
class DisplacementFit {
 public:
  explicit DisplacementFit(const Tree& tree);

  /// Adds the vertices that `bound` of `bounds` encloses, given by their positions in the pools.
  /// O(D log D) for their displacements D, counted once for each influence of a vertex.
  void add(const NodeBounds& bounds, const NodeBound& bound, std::span<const std::uint32_t> places);

  /// Writes the boxes to `bounds`. Precondition: `bounds` is the object given to `add`.
  void finish(NodeBounds& bounds) const;

 private:
  using Boxes = std::vector<DisplacementBox>;

  /// A displacement of a vertex in the body with this number. A vertex that follows several joints
  /// is in the bodies of all of them.
  struct Displaced {
    std::uint32_t body;
    Displacement displacement;
  };

  void gather(std::uint32_t body, std::uint32_t place);
  void box_all(std::vector<Boxes>& bodies, std::size_t first);
  DisplacementBox box_of(std::span<const Displaced> of_one_target) const;

  SkinnedMesh vertices_;                // in the order of the pools
  std::vector<std::uint32_t> numbers_;  // by joint: its number among the joints of the current set
  std::vector<std::uint32_t> vertex_counts_;
  std::vector<Displaced> displaced_;
  std::vector<Boxes> joint_boxes_, shapes_;  // by body
};

/// The pairs of a node's joints. JointPair::first is a number among `vertices.joints()`.
struct DualFit {
  std::vector<JointPair> pairs;
  float product_sum = 0, skew_sum = 0;
};

DualFit fit_dual(const NodeVertices& vertices);

/// Adds the fit to the bounds. `joints` are the vertices' joints.
DualBound add_dual(const DualFit& fit, std::span<const std::uint16_t> joints,
                   const NodeBound& bound, NodeBounds& bounds);

/// Finds the pairs of joints that share a vertex, in ascending order. O(P K^2 log P) for P vertices
/// in pools with K influences.
std::vector<JointLink> find_joint_links(const Tree& tree);

/// Returns the number of the link of two joints. Precondition: they are linked.
std::uint32_t link_of(std::span<const JointLink> links, std::uint16_t a, std::uint16_t b);

}  // namespace pelt::detail
