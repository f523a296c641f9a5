#include "model/triangles_below.hpp"

namespace pelt::detail {

void count_triangles_below(Tree& tree) {
  tree.triangles_below.assign(tree.nodes.size(), 0);
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const Node& node = tree.nodes[n];
    for (unsigned slot = 0; slot < unsigned{node.cluster_count} + node.child_count; ++slot)
      tree.triangles_below[n] += triangles_below(tree, node, slot);
  }
}

}  // namespace pelt::detail
