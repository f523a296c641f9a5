#pragma once

/// The vertices below a node, in double precision, for fitting bounds.

#include "base/vec3.hpp"
#include "model/tree.hpp"

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

}  // namespace pelt::detail
