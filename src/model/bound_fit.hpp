#pragma once

/// The coefficients of one node's bound, fitted to its rest vertices; see node_bounds.hpp.

#include "model/node_bounds.hpp"
#include "model/node_vertices.hpp"

#include <vector>

namespace pelt::detail {

/// What the margins need of the whole mesh.
struct WeightRounding {
  double influences = 0;  ///< the most of one vertex
  double sum_error = 0;   ///< the furthest that a vertex's weights sum from 1
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

}  // namespace pelt::detail
