#include "paper/weight_bounds.hpp"

#include "paper/weight_corners.hpp"

#include <algorithm>
#include <map>

namespace pelt::paper {
namespace {

using JointList = std::vector<std::uint16_t>;

/// J(v) of every vertex, as an index into a list of distinct joint sets.
struct VertexJointSets {
  std::vector<std::uint32_t> set_of_vertex;
  std::vector<JointList> sets;
};

VertexJointSets distinct_joint_sets(const SkinnedMesh& mesh) {
  VertexJointSets result;
  std::map<JointList, std::uint32_t> numbers;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    JointList joints;
    for (const detail::Influence& influence : mesh.influences_of(v))
      joints.push_back(static_cast<std::uint16_t>(influence.joint));
    const auto [entry, is_new] =
        numbers.emplace(std::move(joints), static_cast<std::uint32_t>(result.sets.size()));
    if (is_new) result.sets.push_back(entry->first);
    result.set_of_vertex.push_back(entry->second);
  }
  return result;
}

/// Limits of the weights in the corners of a model: 16 MiB, and 2 KiB for each triangle.
constexpr std::size_t kCornerWeights = std::size_t{1} << 22, kCornerWeightsPerTriangle = 512;

class Builder {
 public:
  Builder(const SkinnedMesh& mesh, const SphereTree& tree)
      : mesh_(mesh),
        tree_(tree),
        vertex_sets_(distinct_joint_sets(mesh)),
        seen_in_(mesh.vertex_count(), 0),
        most_corner_weights_(kCornerWeights + kCornerWeightsPerTriangle * mesh.triangle_count()),
        intervals_(vertex_sets_.sets.size()) {
    for (const JointList& joints : vertex_sets_.sets) {
      first_joint_.push_back(static_cast<std::uint32_t>(bounds_.joints.size()));
      bounds_.joints.insert(bounds_.joints.end(), joints.begin(), joints.end());
    }
  }

  WeightBounds build(BoundKind kind) && {
    prepare_single_joints();
    bounds_.set_begin.push_back(0);
    for (const Node& node : tree_.nodes) {
      collect_intervals(node);
      if (kind == BoundKind::optimised && corners_fit())
        for (const std::uint32_t set : sets_of_node_) append_set(set);
      else
        append_single_joints();
      for (const std::uint32_t set : sets_of_node_) intervals_[set].clear();
      finish_node();
    }
    return std::move(bounds_);
  }

 private:
  /// Weight intervals of the joint sets of a node's vertices, in ascending order of the sets.
  void collect_intervals(const Node& node) {
    sets_of_node_.clear();
    ++stamp_;
    for (const std::uint32_t t : tree_.triangles_of(node))
      for (const std::uint32_t v : mesh_.triangles[t])
        if (seen_in_[v] != stamp_) {
          seen_in_[v] = stamp_;
          include_vertex(v);
        }
    std::sort(sets_of_node_.begin(), sets_of_node_.end());
  }

  void include_vertex(std::uint32_t v) {
    const auto influences = mesh_.influences_of(v);
    const std::uint32_t set = vertex_sets_.set_of_vertex[v];
    std::vector<WeightInterval>& intervals = intervals_[set];
    if (intervals.empty()) {
      intervals.resize(influences.size());
      sets_of_node_.push_back(set);
    }
    double sum = 0;
    for (const auto& influence : influences) sum += static_cast<double>(influence.weight);
    for (std::size_t i = 0; i < influences.size(); ++i)
      intervals[i].include(static_cast<double>(influences[i].weight) / sum);
  }

  /// Whether the corners of the current node fit into memory. Real characters need a twentieth of
  /// the limit; a file made to need more gets the bound of eq. 2, which needs no corners.
  bool corners_fit() const {
    constexpr std::size_t kMaxCornersOfFewJoints = 280;
    std::size_t most = 0;
    for (const std::uint32_t set : sets_of_node_) {
      const std::size_t n = intervals_[set].size();
      most += n * (n > kMaxEnumeratedJoints ? n : kMaxCornersOfFewJoints);
    }
    return bounds_.corners.size() + most <= most_corner_weights_;
  }

  void append_set(std::uint32_t set) {
    JointSet entry;
    entry.first_joint = first_joint_[set];
    entry.first_corner = static_cast<std::uint32_t>(bounds_.corners.size());
    entry.joint_count = static_cast<std::uint16_t>(intervals_[set].size());
    corners_.clear();
    append_weight_corners(intervals_[set], corners_);
    entry.corner_count = static_cast<std::uint16_t>(corners_.size() / entry.joint_count);
    for (const double w : corners_) bounds_.corners.push_back(static_cast<float>(w));
    bounds_.sets.push_back(entry);
  }

  /// Eq. 2 as a special case: a single joint is a joint set whose only corner is the weight 1.
  void prepare_single_joints() {
    first_single_joint_ = static_cast<std::uint32_t>(bounds_.joints.size());
    for (std::uint32_t j = 0; j < mesh_.joint_count; ++j)
      bounds_.joints.push_back(static_cast<std::uint16_t>(j));
    bounds_.corners.push_back(1);
  }

  void append_single_joints() {
    JointList joints;
    for (const std::uint32_t set : sets_of_node_)
      joints.insert(joints.end(), vertex_sets_.sets[set].begin(), vertex_sets_.sets[set].end());
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    for (const std::uint16_t joint : joints)
      bounds_.sets.push_back(JointSet{first_single_joint_ + joint, 0, 1, 1});
  }

  void finish_node() {
    std::uint32_t corner_count = 0;
    for (std::size_t s = bounds_.set_begin.back(); s < bounds_.sets.size(); ++s) {
      corner_count += bounds_.sets[s].corner_count;
      bounds_.max_joints = std::max<std::uint32_t>(bounds_.max_joints, bounds_.sets[s].joint_count);
    }
    bounds_.max_corners = std::max(bounds_.max_corners, corner_count);
    bounds_.set_begin.push_back(static_cast<std::uint32_t>(bounds_.sets.size()));
  }

  const SkinnedMesh& mesh_;
  const SphereTree& tree_;
  VertexJointSets vertex_sets_;
  std::vector<std::uint32_t> first_joint_;  // by distinct joint set
  std::uint32_t first_single_joint_ = 0;
  std::vector<std::uint32_t> seen_in_;  // by vertex: the last node that contained it
  std::uint32_t stamp_ = 0;
  std::size_t most_corner_weights_;
  std::vector<std::vector<WeightInterval>> intervals_;  // by distinct joint set; of this node
  std::vector<std::uint32_t> sets_of_node_;
  std::vector<double> corners_;
  WeightBounds bounds_;
};

}  // namespace

WeightBounds build_weight_bounds(const SkinnedMesh& mesh, const SphereTree& tree, BoundKind kind) {
  return Builder(mesh, tree).build(kind);
}

}  // namespace pelt::paper
