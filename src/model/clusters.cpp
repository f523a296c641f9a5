#include "model/clusters.hpp"

#include "base/assert.hpp"
#include "model/cluster_cut.hpp"
#include "model/tree.hpp"

#include <numeric>
#include <utility>

namespace pelt::detail {
namespace {

/// From this depth on, sets are halved, which takes at most 31 levels.
constexpr std::uint32_t kHalvingDepth = kMaxClusterTreeDepth - 32;

class ClusterTreeBuilder {
 public:
  explicit ClusterTreeBuilder(const SampleBoxes& boxes) : boxes_(boxes), cut_(boxes) {
    tree_.triangle_order.resize(boxes.triangle_count());
    std::iota(tree_.triangle_order.begin(), tree_.triangle_order.end(), 0);
  }

  ClusterTree build() && {
    add_node(0, boxes_.triangle_count(), 1);
    for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
      if (tree_.nodes[n].count > kMaxClusterTriangles) split(n);
    return std::move(tree_);
  }

 private:
  void add_node(std::uint32_t first, std::uint32_t count, std::uint32_t depth) {
    tree_.nodes.push_back({first, count, 0, mean_area(triangles(first, count))});
    depths_.push_back(depth);
  }

  void split(std::uint32_t n) {
    const std::uint32_t first = tree_.nodes[n].first, count = tree_.nodes[n].count;
    const auto set = triangles(first, count);
    const std::uint32_t left =
        depths_[n] < kHalvingDepth ? cut_.cheapest(set) : ClusterCut::halves(set);
    tree_.nodes[n].left_child = static_cast<std::uint32_t>(tree_.nodes.size());
    add_node(first, left, depths_[n] + 1);
    add_node(first + left, count - left, depths_[n] + 1);
  }

  std::span<std::uint32_t> triangles(std::uint32_t first, std::uint32_t count) {
    return {tree_.triangle_order.data() + first, count};
  }

  double mean_area(std::span<const std::uint32_t> set) const {
    double sum = 0;
    for (std::uint32_t s = 0; s < boxes_.sample_count(); ++s) {
      Box4 box = empty_box();
      for (const std::uint32_t t : set) box = unite(box, boxes_.of(t)[s]);
      sum += half_area(box);
    }
    return sum / boxes_.sample_count();
  }

  const SampleBoxes& boxes_;
  ClusterCut cut_;
  ClusterTree tree_;
  std::vector<std::uint32_t> depths_;  // by node
};

}  // namespace

ClusterTree build_cluster_tree(const SampleBoxes& boxes) {
  PELT_ASSERT(boxes.triangle_count() > 0);
  return ClusterTreeBuilder(boxes).build();
}

}  // namespace pelt::detail
