#include "model/welded_vertices.hpp"

namespace pelt::detail {

void index_welded_vertices(Tree& tree) {
  tree.welded_vertices.clear();
  for (std::uint32_t v = 0; v < tree.vertex_count(); ++v) {
    const std::uint32_t into = tree.place_vertices[tree.vertex_places[v]];
    if (into != v) tree.welded_vertices.push_back({v, into});
  }
  tree.welded_vertices.shrink_to_fit();
}

}  // namespace pelt::detail
