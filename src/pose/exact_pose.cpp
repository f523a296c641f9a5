#include "pose/exact_pose.hpp"

#include "pose/open_node.hpp"

namespace pelt::detail {

ExactPose::ExactPose(const Tree& tree) : tree_(tree), instance_(tree) { close_all(); }

void ExactPose::copy(const Instance& posed) {
  instance_.palette = posed.palette;
  instance_.given = posed.given;
  close_all();
}

Result<void> ExactPose::set_morph_weights(std::span<const float> weights) {
  return instance_.palette.set_morph_weights(weights);
}

Result<void> ExactPose::set_palette(std::span<const Matrix4> palette) {
  Result<void> taken = instance_.palette.set(palette);
  if (!taken) return taken;
  instance_.given = {};
  close_all();
  return {};
}

void ExactPose::close_all() {
  arena_.clear();
  instance_.root_box.known = false;
  instance_.opened = OpenedNodes(static_cast<std::uint32_t>(tree_.nodes.size()), arena_);
}

QueryStats ExactPose::open_all() { return detail::open_all(posed_tree()); }

PosedTree ExactPose::posed_tree() { return instance_.posed_tree(tree_, no_bounds_, arena_); }

}  // namespace pelt::detail
