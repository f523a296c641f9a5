#pragma once

/// How a crowd is asked. A query runs in passes, each over all instances or pairs: boxes that
/// overlap (sweep.hpp), the filters, groups without common instances (pair_groups.hpp), and at last
/// the descents. A worker does a whole group by itself; where a group is so large that others would
/// wait for it, they share its pairs.
///
/// Answers and stats are those of one thread. A descent depends on the two palettes alone: a node
/// is opened to the same bits by whoever needs it, and counted by the one who published it. What
/// the descents found is put in order after them.
///
/// Memory may end in any pass and on any thread. The exception then leaves `run`; every pass of the
/// next query begins anew from the palettes, so nothing that was left unfinished is seen.

#include <pelt/crowd.hpp>

#include "base/arena.hpp"
#include "base/work_shares.hpp"
#include "base/workers.hpp"
#include "crowd/instances.hpp"
#include "crowd/pair_groups.hpp"
#include "crowd/sweep.hpp"
#include "query/scratch.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// Two instances in contact.
struct TouchingPair {
  CrowdPair instances;
  std::span<const Contact> contacts;
};

class CrowdQuery {
 public:
  /// Finds the pairs in contact, and up to `max_contacts` contacts of each.
  CrowdStats run(CrowdInstances& instances, const CrowdOptions& options,
                 std::uint32_t max_contacts);

  /// What the last run found, ascending. Valid until the next one.
  std::span<const TouchingPair> touching() const { return touching_; }

  std::size_t memory_bytes() const;

 private:
  /// What one thread needs for itself.
  struct alignas(64) Worker {
    Arena nodes;                 // of the group that it does by itself
    Arena shared_nodes;          // of groups whose pairs are shared, for all to use
    Arena contacts;              // of this query
    std::size_t most_nodes = 0;  // bytes that a group of this query took
    std::vector<TouchingPair> touching;
    Scratch scratch;
    QueryStats work;

    void collide_group(CrowdInstances& instances, std::span<const CrowdPair> group,
                       std::uint32_t max_contacts);
    void collide_pair(CrowdInstances& instances, const CrowdPair& pair, Arena& arena,
                      std::uint32_t max_contacts);
    std::size_t memory_bytes() const;
  };

  void box_instances(CrowdInstances& instances);
  void filter_pairs(CrowdInstances& instances, const CrowdOptions& options);
  void start_workers(std::uint32_t threads);
  void share_out();
  void collide(CrowdInstances& instances, std::uint32_t max_contacts);
  CrowdStats gather();
  void even_out();

  Sweep sweep_;
  std::uint64_t moved_ = 0;                  // instances since the last query that ended well
  std::vector<CrowdPair> pairs_;             // to be asked
  PairGroups groups_;                        // of them
  std::vector<CrowdPair> shared_pairs_;      // of the large groups
  std::vector<std::uint32_t> small_groups_;  // the others
  WorkShares pair_shares_, group_shares_;    // of those two
  std::vector<Worker> workers_;
  std::uint32_t worker_count_ = 1;  // of this query
  std::vector<TouchingPair> touching_;
  Workers threads_;
};

}  // namespace pelt::detail
