#include "bounds/level_boxes.hpp"
#include "pose/open_node.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

class Descent {
 public:
  Descent(const Pose& pose, const Pose& whole, std::uint32_t level, LevelBoxes& out)
      : tree_(pose.model.detail().tree), pose_(pose), whole_(whole), level_(level), out_(out) {}

  void run() {
    const RootBox& root = whole_.root_box;
    if (level_ > 0) return descend(0, 1);
    add({root.low[0], root.low[1], root.low[2]}, {root.high[0], root.high[1], root.high[2]},
        state_of(0, pose_.root_box.known));
  }

 private:
  const OpenedNode* opened(std::uint32_t node) const {
    return pose_.opened ? pose_.opened[node] : nullptr;
  }

  BoxState state_of(std::uint32_t node, bool has_box) const {
    if (opened(node) != nullptr) return BoxState::opened;
    return has_box ? BoxState::refitted : BoxState::untouched;
  }

  static BoxState cluster_state(const OpenedNode* node, std::uint32_t slot) {
    if (node == nullptr) return BoxState::untouched;
    return node->triangles[slot].load(std::memory_order_acquire) != nullptr ? BoxState::opened
                                                                            : BoxState::refitted;
  }

  void add(const Vec3& low, const Vec3& high, BoxState state) {
    out_.boxes.insert(out_.boxes.end(), {low.x, low.y, low.z, high.x, high.y, high.z});
    out_.states.push_back(state);
  }

  void add(const OpenedNode& boxes, std::uint32_t slot, BoxState state) {
    add({boxes.low[0][slot], boxes.low[1][slot], boxes.low[2][slot]},
        {boxes.high[0][slot], boxes.high[1][slot], boxes.high[2][slot]}, state);
  }

  /// `level` is the level of the node's slots.
  void descend(std::uint32_t n, std::uint32_t level) {
    const Node& node = tree_.nodes[n];
    const OpenedNode& boxes = *whole_.opened[n];
    for (std::uint32_t c = 0; c < node.cluster_count; ++c)
      add(boxes, c, cluster_state(opened(n), c));
    for (std::uint32_t c = 0; c < node.child_count; ++c) {
      const std::uint32_t child = node.first_child + c;
      if (level < level_)
        descend(child, level + 1);
      else
        add(boxes, node.cluster_count + c, state_of(child, opened(n) != nullptr));
    }
  }

  const Tree& tree_;
  const Pose& pose_;
  const Pose& whole_;
  std::uint32_t level_;
  LevelBoxes& out_;
};

}  // namespace

std::uint32_t level_count(const Tree& tree) {
  std::vector<std::uint32_t> level(tree.nodes.size(), 0);
  std::uint32_t deepest = 0;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {  // parents come first
    const Node& node = tree.nodes[n];
    for (std::uint32_t c = 0; c < node.child_count; ++c) level[node.first_child + c] = level[n] + 1;
    deepest = std::max(deepest, level[n] + 1);
  }
  return deepest + 1;
}

std::uint32_t opened_node_count(const Pose& pose) {
  if (!pose.opened) return 0;
  std::uint32_t count = 0;
  for (std::uint32_t n = 0; n < pose.model.detail().tree.nodes.size(); ++n)
    if (pose.opened[n] != nullptr) ++count;
  return count;
}

void copy_with_all_bounds(const Pose& pose, Pose& whole) {
  whole.close_all();
  whole.palette = pose.palette;
  whole.given = pose.given;
  const PosedTree posed = whole.posed_tree();
  make_table(posed);
  compute_all_bounds(posed);
}

void level_boxes(const Pose& pose, const Pose& whole, std::uint32_t level, LevelBoxes& out) {
  out.boxes.clear();
  out.states.clear();
  Descent(pose, whole, level, out).run();
}

}  // namespace pelt::detail
