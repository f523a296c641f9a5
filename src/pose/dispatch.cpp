/// Selects the instruction set for the functions of this folder.

#include "base/dispatch.hpp"
#include "pose/open_fully.hpp"
#include "pose/open_node.hpp"
#include "pose/root_box.hpp"

namespace pelt::detail {

PELT_DECLARE_TARGETS(box_root)
PELT_DECLARE_TARGETS(pose_vertices)
PELT_DECLARE_TARGETS(root_box)
PELT_DECLARE_TARGETS(open_closed_node)
PELT_DECLARE_TARGETS(open_all_exactly)
PELT_DECLARE_TARGETS(open_fully)

inline namespace PELT_TARGET {

RootBox box_root(const NodeBounds& bounds, const Palette& palette) {
  return PELT_CHOOSE(box_root)(bounds, palette);
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

QueryStats open_all_exactly(const PosedTree& posed) { return PELT_CHOOSE(open_all_exactly)(posed); }

QueryStats open_fully(const PosedTree& posed) { return PELT_CHOOSE(open_fully)(posed); }

}  // namespace PELT_TARGET
}  // namespace pelt::detail
