#pragma once

/// Fits what a node's bound adds with dual quaternion skinning; see dual_bounds.hpp.

#include "model/node_bounds.hpp"
#include "model/node_vertices.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// The pairs of a node's joints. JointPair::first is a number among `vertices.joints()`.
struct DualFit {
  std::vector<JointPair> pairs;
  float product_sum = 0, skew_sum = 0;
};

DualFit fit_dual(const NodeVertices& vertices);

/// Adds the fit to the bounds. `joints` are the vertices' joints.
DualBound add_dual(const DualFit& fit, std::span<const std::uint16_t> joints,
                   const NodeBound& bound, NodeBounds& bounds);

}  // namespace pelt::detail
