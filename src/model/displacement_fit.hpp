#pragma once

#include "model/node_bounds.hpp"
#include "skin/skinned_mesh.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

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

}  // namespace pelt::detail
