#pragma once

#include "model/node_bounds.hpp"
#include "skin/skinned_mesh.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// The boxes around the displacements of the vertices of each rest body. For one set of vertices
/// after the other whose bound is there already, in any order, and then for all bounds at once.
class DisplacementFit {
 public:
  explicit DisplacementFit(const Tree& tree);

  /// Takes the vertices, named by their places in the pools, that `bound` of `bounds` is around.
  /// O(D log D) for their displacements D, counted once for each of a vertex's influences.
  void add(const NodeBounds& bounds, const NodeBound& bound, std::span<const std::uint32_t> places);

  /// Writes what was found to `bounds`, the same as before.
  void finish(NodeBounds& bounds) const;

 private:
  using Boxes = std::vector<DisplacementBox>;

  /// Of a vertex in the body of that number; one that follows several joints is in all of theirs.
  struct Displaced {
    std::uint32_t body;
    Displacement displacement;
  };

  void gather(std::uint32_t body, std::uint32_t place);
  void box_all(std::vector<Boxes>& bodies, std::size_t first);
  DisplacementBox box_of(std::span<const Displaced> of_one_target) const;

  SkinnedMesh vertices_;                // in the order of the pools
  std::vector<std::uint32_t> numbers_;  // by joint; of those of the set at hand
  std::vector<std::uint32_t> vertex_counts_;
  std::vector<Displaced> displaced_;
  std::vector<Boxes> joint_boxes_, shapes_;  // by body
};

}  // namespace pelt::detail
