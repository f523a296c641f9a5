#include "model/check_tree.hpp"

#include "skin/skinned_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::detail {
namespace {

/// Range of the vertices of a node's pool. The vertices without triangles form a last node.
struct Pool {
  std::size_t begin, end;
};

Pool pool_of(const Tree& tree, std::size_t node) {
  if (node < tree.nodes.size())
    return {tree.nodes[node].first_vertex,
            std::size_t{tree.nodes[node].first_vertex} + tree.nodes[node].vertex_count};
  return {pool_of(tree, node - 1).end, tree.rest_positions.size()};
}

class MorphCheck {
 public:
  explicit MorphCheck(const Tree& tree)
      : tree_(tree), morphs_(tree.morphs), largest_(tree.morphs.extents.size()) {}

  /// Later checks rely on the earlier ones.
  Problem run() {
    for (const auto check : {&MorphCheck::check_sizes, &MorphCheck::check_node_begin,
                             &MorphCheck::check_nodes, &MorphCheck::check_extents})
      if (Problem found = (this->*check)(); !found.empty()) return found;
    return {};
  }

 private:
  Problem check_sizes();
  Problem check_node_begin();
  Problem check_nodes();
  Problem check_target(std::uint32_t t, const Pool& pool);
  Problem check_displacement(std::size_t i, Vec3& largest);
  Problem check_extents();

  const Tree& tree_;
  const PoolMorphs& morphs_;
  std::vector<Vec3> largest_;  // by target: largest displacement along each axis
  std::size_t displacements_ = 0;
};

Problem MorphCheck::check_sizes() {
  const std::size_t targets = morphs_.extents.size();
  if (targets > kMaxMorphTargets) return problem("morphs.extents has %zu elements", targets);
  const std::size_t expected = targets == 0 ? 0 : tree_.nodes.size() + 2;
  if (morphs_.node_begin.size() != expected)
    return problem("morphs.node_begin has %zu elements, expected %zu", morphs_.node_begin.size(),
                   expected);
  if (targets == 0 && (!morphs_.targets.empty() || !morphs_.displacements.empty()))
    return problem("morphs.targets or displacements has elements, but extents has none");
  if (std::max(morphs_.targets.size(), morphs_.displacements.size()) >= 0xFFFFFFFF)
    return problem("morphs.displacements has %zu elements", morphs_.displacements.size());
  return {};
}

Problem MorphCheck::check_node_begin() {
  const auto& begin = morphs_.node_begin;
  if (begin.empty()) return {};
  if (begin.front() != 0 || begin.back() != morphs_.targets.size())
    return problem("morphs.node_begin goes from %u to %u, expected 0 to %zu", begin.front(),
                   begin.back(), morphs_.targets.size());
  const auto fault = std::is_sorted_until(begin.begin(), begin.end());
  if (fault == begin.end()) return {};
  return problem("morphs.node_begin[%td] is less than the one before it", fault - begin.begin());
}

Problem MorphCheck::check_nodes() {
  for (std::size_t n = 0; n + 1 < morphs_.node_begin.size(); ++n) {
    const Pool pool = pool_of(tree_, n);
    for (std::uint32_t t = morphs_.node_begin[n]; t < morphs_.node_begin[n + 1]; ++t) {
      if (t > morphs_.node_begin[n] && morphs_.targets[t].target <= morphs_.targets[t - 1].target)
        return problem("morphs.targets[%u] does not ascend in its node", t);
      if (Problem found = check_target(t, pool); !found.empty()) return found;
    }
  }
  if (displacements_ != morphs_.displacements.size())
    return problem("morphs.targets have %zu displacements of %zu", displacements_,
                   morphs_.displacements.size());
  return {};
}

/// Checks that the displacements follow those of the previous target, so that each belongs to one.
Problem MorphCheck::check_target(std::uint32_t t, const Pool& pool) {
  const PoolTarget& run = morphs_.targets[t];
  if (run.target >= largest_.size())
    return problem("morphs.targets[%u] is of target %u of %zu", t, run.target, largest_.size());
  if (run.first_displacement != displacements_ || run.displacement_count == 0 ||
      run.displacement_count > morphs_.displacements.size() - displacements_)
    return problem("morphs.targets[%u] has %u displacements from %u on, expected some from %zu on",
                   t, run.displacement_count, run.first_displacement, displacements_);
  std::size_t least = pool.begin;
  for (const std::size_t end = displacements_ + run.displacement_count; displacements_ < end;
       ++displacements_) {
    const std::uint32_t place = morphs_.displacements[displacements_].place;
    if (place < least || place >= pool.end)
      return problem("morphs.displacements[%zu].place is %u, out of order or out of the pool",
                     displacements_, place);
    least = std::size_t{place} + 1;
    if (Problem found = check_displacement(displacements_, largest_[run.target]); !found.empty())
      return found;
  }
  return {};
}

Problem MorphCheck::check_displacement(std::size_t i, Vec3& largest) {
  const Vec3& by = morphs_.displacements[i].by;
  for (const float c : {by.x, by.y, by.z})
    if (!(std::fabs(c) <= kMaxCoordinate))  // also true for NaN
      return problem("morphs.displacements[%zu] has the coordinate %g", i, static_cast<double>(c));
  if (by == Vec3()) return problem("morphs.displacements[%zu] is zero", i);
  largest = {std::max(largest.x, std::fabs(by.x)), std::max(largest.y, std::fabs(by.y)),
             std::max(largest.z, std::fabs(by.z))};
  return {};
}

Problem MorphCheck::check_extents() {
  for (std::size_t m = 0; m < largest_.size(); ++m) {
    const double extent = double{largest_[m].x} + double{largest_[m].y} + double{largest_[m].z};
    if (!(double{morphs_.extents[m]} >= extent && morphs_.extents[m] < kMaxExtent))
      return problem("morphs.extents[%zu] is %g, but displacements reach %g", m,
                     static_cast<double>(morphs_.extents[m]), extent);
  }
  return {};
}

}  // namespace

Problem check_pool_morphs(const Tree& tree) { return MorphCheck(tree).run(); }

}  // namespace pelt::detail
