/// The boxes of a level of the tree, and which of them queries have asked for: Kavan & Zara 2005,
/// figure 5.

#include "base/wide_code.hpp"
#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "model/model.hpp"
#include "pose/pose.hpp"

namespace pelt::wasm {
namespace {

using detail::OpenedNode;

enum class State : std::uint8_t { untouched, refitted, opened };

struct LevelBoxes {
  std::vector<float> boxes;  // [N][6]
  std::vector<std::uint8_t> states;

  void add(const float (&low)[3], const float (&high)[3], State state) {
    boxes.insert(boxes.end(), low, low + 3);
    boxes.insert(boxes.end(), high, high + 3);
    states.push_back(static_cast<std::uint8_t>(state));
  }
};

LevelBoxes& level_boxes() {
  static LevelBoxes boxes;
  return boxes;
}

/// A pose with the same palette, in which all nodes are open.
detail::Pose& open_whole(PoseHandle& handle) {
  if (!handle.whole) handle.whole.emplace(handle.pose.model());
  detail::Pose& whole = handle.whole->detail();
  whole.palette = handle.pose.detail().palette;
  whole.close_all();
  const detail::PosedTree posed = whole.posed_tree();
  make_table(posed);
  detail::wide_code().open_fully(posed);
  return whole;
}

class Descent {
 public:
  Descent(const detail::Pose& pose, const detail::Pose& whole, std::uint32_t level)
      : tree_(pose.model.detail().tree), pose_(pose), whole_(whole), level_(level) {}

  void run(LevelBoxes& out) const {
    const detail::RootBox& root = whole_.root_box;
    if (level_ > 0) return descend(0, 1, out);
    out.add({root.low[0], root.low[1], root.low[2]}, {root.high[0], root.high[1], root.high[2]},
            state_of(0, pose_.root_box.known));
  }

 private:
  const OpenedNode* opened(std::uint32_t node) const {
    return pose_.opened ? pose_.opened[node] : nullptr;
  }

  State state_of(std::uint32_t node, bool has_box) const {
    if (opened(node) != nullptr) return State::opened;
    return has_box ? State::refitted : State::untouched;
  }

  static State cluster_state(const OpenedNode* node, std::uint32_t slot) {
    if (node == nullptr) return State::untouched;
    return node->triangles[slot].load(std::memory_order_acquire) != nullptr ? State::opened
                                                                            : State::refitted;
  }

  static void add(const OpenedNode& boxes, std::uint32_t slot, State state, LevelBoxes& out) {
    out.add({boxes.low[0][slot], boxes.low[1][slot], boxes.low[2][slot]},
            {boxes.high[0][slot], boxes.high[1][slot], boxes.high[2][slot]}, state);
  }

  /// `level` is that of the node's slots.
  void descend(std::uint32_t n, std::uint32_t level, LevelBoxes& out) const {
    const detail::Node& node = tree_.nodes[n];
    const OpenedNode& boxes = *whole_.opened[n];
    for (std::uint32_t c = 0; c < node.cluster_count; ++c)
      add(boxes, c, cluster_state(opened(n), c), out);
    for (std::uint32_t c = 0; c < node.child_count; ++c) {
      const std::uint32_t child = node.first_child + c;
      if (level < level_)
        descend(child, level + 1, out);
      else
        add(boxes, node.cluster_count + c, state_of(child, opened(n) != nullptr), out);
    }
  }

  const detail::Tree& tree_;
  const detail::Pose& pose_;
  const detail::Pose& whole_;
  std::uint32_t level_;
};

}  // namespace

PELT_EXPORT std::uint32_t pelt_node_count(const PoseHandle* handle) {
  return static_cast<std::uint32_t>(handle->pose.model().detail().tree.nodes.size());
}

PELT_EXPORT std::uint32_t pelt_opened_node_count(const PoseHandle* handle) {
  const detail::Pose& pose = handle->pose.detail();
  if (!pose.opened) return 0;
  std::uint32_t count = 0;
  for (std::uint32_t n = 0; n < pose.model.detail().tree.nodes.size(); ++n)
    if (pose.opened[n] != nullptr) ++count;
  return count;
}

/// Returns where the states lie; the boxes are the answer.
PELT_EXPORT const std::uint8_t* pelt_node_boxes(PoseHandle* handle, std::uint32_t level) {
  LevelBoxes& out = level_boxes();
  out = {};
  Descent(handle->pose.detail(), open_whole(*handle), level).run(out);
  answer_data<float>(out.boxes);
  return out.states.data();
}

}  // namespace pelt::wasm
