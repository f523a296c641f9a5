#pragma once

/// The door of this room: contacts of two trees, still and moving. Other rooms also include
/// search.hpp (searches that can be stopped), cluster_pair.hpp (triangles of two clusters) and
/// eager.hpp (poses whose nodes are all open).

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "motion/moving_tree.hpp"
#include "pose/open_node.hpp"
#include "pose/posed_tree.hpp"
#include "query/pair_descent.hpp"
#include "query/scratch.hpp"

#include <optional>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `max_contacts` pairs of intersecting triangles to `scratch.found`, in no
/// particular order.
QueryStats collide_trees(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts);

/// Like `collide_trees`, but stops after `max_work` units of `work_of`, too. `cut_short` then says
/// so.
QueryStats collide_trees_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                                std::uint32_t max_contacts, std::uint64_t max_work);

/// Sets `lowest` to the lowest pair of intersecting triangles, the first that `collide` lists.
/// Empty if none intersect. Overwrites `scratch.found`.
QueryStats lowest_contact(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                          std::optional<Contact>& lowest);

/// Writes at most `options.max_contacts` pairs of triangles that intersect at some time to
/// `scratch.moving`, in no particular order.
MovingStats collide_moving_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                 const MovingOptions& options);

/// Sets `first` to the first contact after the start: of the pairs of triangles that do not
/// intersect at time 0, the one that intersects first; of equal times, the lowest. Without such a
/// pair, `first` is empty.
MovingStats first_contact_of_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                   std::optional<MovingContact>& first);

/// Starts a descent. Returns whether the root boxes overlap. If so, makes the tables of opened
/// nodes.
inline bool begin_descent(const PosedTree& a, const PosedTree& b, QueryStats& work) {
  ++work.node_pairs;
  const RootBox &root_a = root_box(a, work), &root_b = root_box(b, work);
  if (!boxes_overlap(root_a.low, root_a.high, root_b.low, root_b.high)) return false;
  make_table(a);
  make_table(b);
  return true;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
