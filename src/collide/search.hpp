#pragma once

/// A search for contacts that can be stopped: its state, steps and answers. The state is the
/// contacts found so far, and open items. An item is a set of slots of a node of `a` and a set of
/// slots of a node of `b` whose triangles have not been compared yet.

#include <pelt/search.hpp>

#include "base/instruction_set.hpp"
#include "collide/search_work.hpp"
#include "model/tree.hpp"
#include "pose/pose.hpp"
#include "pose/posed_tree.hpp"
#include "query/stack.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelt::detail {

/// The next step of an item.
enum class ItemStep : std::uint8_t {
  compare,    ///< compare the slots of both nodes
  replace_b,  ///< a's node is a child that was not compared yet: replace b's node by its slots
  test,       ///< test the triangles of one cluster of a and several clusters of b, or one of each
};

struct OpenItem {
  float low[4], high[4];  ///< box that contains all contacts; the fourth elements are meaningless
  std::uint32_t node_a, node_b;
  std::uint8_t slots_a, slots_b;  ///< one bit per slot
  ItemStep step;
  std::uint8_t rank;   ///< of the item in the queue
  float depth;         ///< least translation that parts the two boxes
  std::uint32_t next;  ///< item of the same rank
};

inline constexpr std::uint32_t kNoItem = UINT32_MAX;

/// Items by rank. Items of the highest rank are next; of these, the one that was pushed last.
///
///     heads    [ 0 | 1 | ... | 254 | 255 ]        255: depth first
///                |             |
///                v             v
///     pool     item --> item  item --> item --> none
struct OpenItems {
  static constexpr std::uint32_t kRanks = 256, kDepthFirst = kRanks - 1;

  Stack<OpenItem> pool;
  std::array<std::uint32_t, kRanks> heads = {};
  std::array<std::uint64_t, kRanks / 64> occupied = {};  ///< one bit per rank
  std::uint32_t unused = kNoItem;                        ///< list of unused items in the pool
  std::uint32_t count = 0;

  const OpenItem& at(std::uint32_t place) const { return pool.begin()[place]; }

  void clear() {
    pool.clear();
    heads.fill(kNoItem);
    occupied.fill(0);
    unused = kNoItem;
    count = 0;
  }
};

struct SearchState {
  SearchOrder order = SearchOrder::first_contact;
  std::uint32_t max_open = 0;
  OpenItems items;
  Stack<Contact> found;
  NodeSet needed_a, needed_b;
  SearchWork work;
  float whole_size = 0;  ///< longest side of the first region

  /// Squared distance of the farthest corners of two boxes, the least so far.
  double squared_reach = std::numeric_limits<double>::infinity();
};

inline namespace PELT_INSTRUCTION_SET {

/// Starts a search anew: compares the root boxes, and adds the first item if they overlap.
QueryStats start_search(const PosedTree& a, const PosedTree& b, SearchState& state);

/// Makes steps until the granted work is done, nothing is open or, in the order `first_contact`,
/// the first contact is found. Precondition: the state was started with the same poses, which have
/// not changed since.
QueryStats advance_search(const PosedTree& a, const PosedTree& b, SearchState& state);

}  // namespace PELT_INSTRUCTION_SET

/// Calls `visit(item)` for each open item, next ones first.
template <typename Visit>
void each_open(const OpenItems& items, const Visit& visit) {
  for (std::uint32_t rank = OpenItems::kRanks; rank-- > 0;)
    for (std::uint32_t i = items.heads[rank]; i != kNoItem; i = items.at(i).next)
      visit(items.at(i));
}

Verdict verdict_of(const SearchState& state);

/// Number of pairs of triangles of all open items.
std::uint64_t undecided_pairs(const SearchState& state, const Tree& a, const Tree& b);

/// Longest side of the region of any open item.
double resolution_of(const SearchState& state);

/// Upper bound of the distance of the two poses.
double distance_bound(const SearchState& state);

/// Appends the open items.
void append_open_regions(const SearchState& state, const Tree& a, const Tree& b,
                         std::vector<OpenRegion>& regions);

/// A search of two poses, which a caller may change.
struct SearchOfPoses {
  SearchOfPoses(Pose& first, Pose& second) : a(&first), b(&second) {}

  const Tree& tree_a() const { return a->model.detail().tree; }
  const Tree& tree_b() const { return b->model.detail().tree; }

  Pose *a, *b;
  std::uint64_t stamp_a = 0, stamp_b = 0;  ///< of the poses when the search was started
  SearchState state;
  QueryStats unreported;  ///< work of starting
};

}  // namespace pelt::detail
