#pragma once

/// Fits the coefficients of one node's bound to its rest vertices; see node_bounds.hpp.

#include "model/node_bounds.hpp"
#include "model/node_vertices.hpp"

#include <vector>

namespace pelt::detail {

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

}  // namespace pelt::detail
