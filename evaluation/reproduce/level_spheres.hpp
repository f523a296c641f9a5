#pragma once

/// The spheres of the paper's trees, level by level, for drawing.

#include "paper/on_demand.hpp"

namespace pelt::reproduce {

/// The root is on level 1.
std::vector<std::uint32_t> nodes_on_level(const paper::SphereTree& tree, std::uint32_t level);

/// A body after a query that refitted the spheres it needed.
struct AskedBody {
  std::vector<paper::Float4> spheres;  ///< of all nodes, under the palette of the query
  std::vector<bool> refitted;          ///< by node: whether the query refitted it
};

struct AskedPair {
  std::array<AskedBody, 2> bodies;
  QueryStats work;
};

/// Queries two bodies of one model for all contacts.
AskedPair ask_on_demand(const detail::SkinnedMesh& mesh, const paper::SphereModel& model,
                        const std::array<detail::Palette, 2>& palettes);

/// The spheres of all nodes, each refitted.
std::vector<paper::Float4> all_refitted(const paper::SphereModel& model,
                                        const detail::Palette& palette);

}  // namespace pelt::reproduce
