#pragma once

/// How a crowd is asked. A query runs in passes, each over all instances or pairs: boxes that
/// overlap (sweep.hpp), the filters, room for what will be opened, and at last the descents, which
/// several threads share pair by pair.
///
/// Answers and stats are those of one thread. A descent depends on the two palettes alone: a node
/// is opened to the same bits by whoever needs it, and counted by the one who published it. What
/// the descents found is put in order after them.

#include <pelt/crowd.hpp>

#include "base/scratch.hpp"
#include "base/work_shares.hpp"
#include "base/workers.hpp"
#include "crowd/instances.hpp"
#include "crowd/sweep.hpp"

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

  /// Must be told before an instance is removed.
  void forget(std::uint32_t instance) { std::erase(near_, instance); }

  std::size_t memory() const;

 private:
  /// What one thread needs for itself.
  struct alignas(64) Worker {
    Arena nodes;     // of this frame: until instances move
    Arena contacts;  // of this query
    std::vector<TouchingPair> touching;
    Scratch scratch;
    QueryStats work;
  };

  std::uint64_t box_instances(CrowdInstances& instances);
  void filter_pairs(CrowdInstances& instances, const CrowdOptions& options);
  void close_all(CrowdInstances& instances);
  void make_room(CrowdInstances& instances);
  void start_workers(std::uint32_t threads);
  void collide_pairs(CrowdInstances& instances, std::uint32_t max_contacts);
  static void collide_pair(CrowdInstances& instances, const CrowdPair& pair, Worker& worker,
                           std::uint32_t max_contacts);
  CrowdStats gather();
  void even_out();

  Sweep sweep_;
  std::vector<CrowdPair> pairs_;     // to be asked, neighbours in space together
  std::vector<std::uint32_t> near_;  // instances that may be open, each once
  std::vector<Worker> workers_;
  std::uint32_t worker_count_ = 1;  // of this query
  std::vector<TouchingPair> touching_;
  WorkShares shares_;
  Workers threads_;
};

}  // namespace pelt::detail
