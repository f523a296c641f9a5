#pragma once

/// The tables of the section on the cost of a refit, and the time of one refit of the paper's
/// method over three possible causes: the joints of a node, its corners, and the vertices below it.

#include "evaluation/reproduce/report.hpp"
#include "paper/refit.hpp"

namespace pelt::reproduce {

/// Facts about a node that do not depend on the pose.
struct NodeFacts {
  double joints = 0;    ///< sum of p_i over its joint sets
  double corners = 0;   ///< sum of m_i
  double flops = 0;     ///< the formula of section 4.2
  double vertices = 0;  ///< below it, each once
};

/// Facts about all nodes.
std::vector<NodeFacts> facts_of(const paper::SphereModel& model, const detail::SkinnedMesh& mesh);

/// Nodes with a similar value of one fact, and the means of their facts.
struct NodeClass {
  double nodes = 0;
  NodeFacts facts;
  double nanoseconds = 0;  ///< a refit, with hot caches
};

/// Classes of nodes with equal or, if large, similar values of `fact`, in ascending order. Leaves
/// out classes with few nodes.
std::vector<NodeClass> time_classes(const paper::SphereModel& model, const detail::Palette& palette,
                                    std::span<const NodeFacts> facts, double NodeFacts::*fact,
                                    std::uint32_t repetitions);

/// The mesh with other weights. All vertices follow the first two joints, with weights that vary
/// from vertex to vertex, so every node has the same joint set and the same number of corners.
detail::SkinnedMesh with_one_joint_set(const detail::SkinnedMesh& mesh);

/// The counted operations of a refit beside the formula of section 4.2, one row for each of the
/// three characters.
Result<Table> flops_table();

/// Refitting all spheres of two men, on demand and bottom-up, beside the paper's figures.
Result<Table> all_spheres_table(const Conditions& conditions);

/// Refitting all bounds of the three characters, and building their trees again, by the paper's
/// methods and by ours.
Result<Table> rebuild_table(const Conditions& conditions);

}  // namespace pelt::reproduce
