/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "pose/open_node.hpp"
#include "pose/pose_boxes.hpp"

namespace pelt::detail {

PELT_DECLARE_VERSIONS(are_within)
PELT_DECLARE_VERSIONS(refit_given)
PELT_DECLARE_VERSIONS(box_root)
PELT_DECLARE_VERSIONS(pose_vertices)
PELT_DECLARE_VERSIONS(root_box)
PELT_DECLARE_VERSIONS(open_closed_node)
PELT_DECLARE_VERSIONS(open_all)
PELT_DECLARE_VERSIONS(compute_all_bounds)

inline namespace PELT_INSTRUCTION_SET {

bool are_within(std::span<const Vec3> vertices) { return PELT_CHOOSE(are_within)(vertices); }

GivenVertices refit_given(const Tree& tree, std::span<const Vec3> vertices, Arena& arena) {
  return PELT_CHOOSE(refit_given)(tree, vertices, arena);
}

RootBox box_root(const NodeBounds& bounds, const Palette& palette, const GivenVertices& given) {
  return PELT_CHOOSE(box_root)(bounds, palette, given);
}

void pose_vertices(const Tree& tree, const Palette& palette, std::span<Vec3> out) {
  PELT_CHOOSE(pose_vertices)(tree, palette, out);
}

const RootBox& root_box(const PosedTree& posed, QueryStats& work) {
  return PELT_CHOOSE(root_box)(posed, work);
}

const OpenedNode& open_closed_node(const PosedTree& posed, std::uint32_t node, QueryStats& work) {
  return PELT_CHOOSE(open_closed_node)(posed, node, work);
}

QueryStats open_all(const PosedTree& posed) { return PELT_CHOOSE(open_all)(posed); }

QueryStats compute_all_bounds(const PosedTree& posed) {
  return PELT_CHOOSE(compute_all_bounds)(posed);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
