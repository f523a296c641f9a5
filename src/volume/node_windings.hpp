#pragma once

/// Winding numbers of another surface around the vertices of one node. If the winding number around
/// one vertex is known, it is known around all vertices that triangles of the node connect with it.

#include "model/triangle_places.hpp"
#include "query/scratch.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace pelt::detail {

class NodeWindings {
 public:
  /// `turns`: ascending by place, for all triangles of the tree. Several turns of one triangle
  /// add up.
  NodeWindings(const Tree& tree, const Node& node, std::span<const WindingTurns> turns);

  /// Whether the winding number around corner 0 of a triangle is known.
  bool is_known(std::uint32_t place) const { return at(place) != kUnknown; }

  /// The winding number around corner 0 of a triangle.
  std::int32_t at(std::uint32_t place) const { return windings_[vertex(place, 0)]; }

  /// Sets the winding number around corner 0 of a triangle, and all that follow from it.
  void set(std::uint32_t place, std::int32_t winding);

 private:
  static constexpr std::int32_t kUnknown = INT32_MIN;
  static constexpr std::size_t kMaxTriangles = std::size_t{kMaxSlots} * kMaxClusterTriangles;

  std::size_t vertex(std::uint32_t place, std::size_t corner) const {
    return tree_.corners[place][corner] / kFloatsPerVertex;
  }

  bool spread(std::uint32_t place);

  const Tree& tree_;
  const Places places_;
  std::array<std::array<std::int32_t, 3>, kMaxTriangles> turns_;  // from corner 0 to each corner
  std::array<std::int32_t, 3 * kMaxTriangles> windings_;          // by vertex of the pool
};

}  // namespace pelt::detail
