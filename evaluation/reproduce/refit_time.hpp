#pragma once

/// How long one refit of the paper's takes, over what could decide it: the joints and corners of a
/// node, and the vertices below it.

#include "evaluation/paper/refit.hpp"
#include "evaluation/reproduce/report.hpp"

namespace pelt::reproduce {

/// What is known of a node beforehand.
struct NodeFacts {
  double joints = 0;    ///< sum of p_i over its joint sets
  double corners = 0;   ///< sum of m_i
  double flops = 0;     ///< the formula of section 4.2
  double vertices = 0;  ///< below it, each once
};

/// By node.
std::vector<NodeFacts> facts_of(const paper::SphereModel& model, const detail::SkinnedMesh& mesh);

/// Nodes that are alike in one of their facts, and the means of what is known of them.
struct NodeClass {
  double nodes = 0;
  NodeFacts facts;
  double nanoseconds = 0;  ///< a refit, with hot caches
};

/// Classes of nodes whose `fact` is the same or, where it is larger, much the same; those with few
/// nodes are left out. Ascending.
std::vector<NodeClass> time_classes(const paper::SphereModel& model, const detail::Palette& palette,
                                    std::span<const NodeFacts> facts, double NodeFacts::*fact,
                                    std::uint32_t repetitions);

/// The mesh with other weights: all vertices follow the first two joints, with weights that vary
/// from vertex to vertex, so that every node has the same joint set and as many corners.
detail::SkinnedMesh with_one_joint_set(const detail::SkinnedMesh& mesh);

}  // namespace pelt::reproduce
