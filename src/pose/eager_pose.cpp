#include "pose/eager_pose.hpp"

#include "pose/open_node.hpp"

namespace pelt::detail {

EagerPose::EagerPose(const Tree& tree) : tree_(tree), instance_(tree) { close_all(); }

void EagerPose::copy(const Instance& posed) {
  instance_.palette = posed.palette;
  instance_.given = posed.given;
  close_all();
}

Result<void> EagerPose::set_morph_weights(std::span<const float> weights) {
  return instance_.palette.set_morph_weights(weights);
}

Result<void> EagerPose::set_palette(std::span<const Matrix4> palette) {
  Result<void> taken = instance_.palette.set(palette);
  if (!taken) return taken;
  instance_.given = {};
  close_all();
  return {};
}

void EagerPose::close_all() {
  arena_.clear();
  instance_.root_box.known = false;
  instance_.opened = OpenedNodes(static_cast<std::uint32_t>(tree_.nodes.size()), arena_);
}

QueryStats EagerPose::open_all() { return detail::open_all(posed_tree()); }

PosedTree EagerPose::posed_tree() { return instance_.posed_tree(tree_, no_bounds_, arena_); }

}  // namespace pelt::detail
