#pragma once

/// Queries of a crowd. A query runs in passes over all instances or pairs: overlapping boxes,
/// filters, islands (broad_phase.hpp for both), and finally the descents. A worker processes a
/// whole island alone. If an island is so large that others would wait for it, the workers share
/// its pairs.
///
/// Answers and stats do not depend on the number of threads. A descent depends only on the two
/// palettes: every thread opens a node to the same bits, and the thread that publishes the node
/// counts it. The results of the descents are sorted at the end. A test of an instance against
/// itself opens all nodes at once, with tighter boxes than a descent would. So it always precedes
/// the tests of its instance against others.
///
/// An allocation may fail in any pass and on any thread. The exception then leaves `run`. Every
/// pass of the next query starts again from the palettes, so unfinished data is never used.

#include <pelt/crowd.hpp>

#include "base/arena.hpp"
#include "base/workers.hpp"
#include "crowd/broad_phase.hpp"
#include "crowd/instances.hpp"
#include "query/scratch.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// Two instances in contact, or an instance in contact with itself.
struct TouchingPair {
  CrowdPair instances;
  std::span<const Contact> contacts;
  std::span<const MovingContact> moving;  // of a query of a step, instead of `contacts`
};

class CrowdQuery {
 public:
  /// Finds the pairs in contact, and up to `max_contacts` contacts of each.
  CrowdStats run(CrowdInstances& instances, const CrowdOptions& options,
                 std::uint32_t max_contacts);

  /// Finds the pairs in contact at any time of the step.
  CrowdStats run_moving(CrowdInstances& instances, const CrowdOptions& options,
                        const MovingOptions& moving);

  /// Returns the pairs of instances that `options` selects and whose boxes overlap, and counts the
  /// boxes that were computed since the last query in `work`. Closes all nodes.
  std::span<const CrowdPair> find_pairs(CrowdInstances& instances, const CrowdOptions& options,
                                        QueryStats& work);

  /// Results of the last run, ascending. Valid until the next run.
  std::span<const TouchingPair> touching() const { return touching_; }

  std::size_t memory_bytes() const;

 private:
  /// The input of a run, which all workers read. `Ask`: AskStill or AskMoving.
  template <typename Ask>
  struct Question {
    CrowdInstances& instances;
    std::span<const SelfFilter* const> self_filters;  // see self_filters_
    Ask ask;
  };

  /// Memory and results of one thread.
  struct alignas(64) Worker {
    Arena nodes;                 // of the island that the worker processes alone
    Arena shared_nodes;          // of islands whose pairs are shared
    Arena contacts;              // of this query
    std::size_t most_nodes = 0;  // largest number of bytes of an island in this query
    std::vector<TouchingPair> touching;
    Scratch scratch;
    QueryStats work;
    LeftOut left_out;

    void clear();
    template <typename Ask>
    void collide_island(const Question<Ask>& question, std::span<const CrowdPair> island);
    template <typename Ask>
    void collide_pair(const Question<Ask>& question, const CrowdPair& pair, Arena& arena);
    template <typename Ask>
    void collide_self(const Question<Ask>& question, std::uint32_t instance, Arena& arena);
    template <typename Ask>
    void keep_found(const CrowdPair& pair);
    std::size_t memory_bytes() const;
  };

  template <typename Ask>
  CrowdStats answer(CrowdInstances& instances, const CrowdOptions& options, const Ask& ask);
  void box_instances(CrowdInstances& instances, bool in_step);
  void filter_pairs(CrowdInstances& instances, const CrowdOptions& options);
  void add_self_tests(CrowdInstances& instances, const CrowdOptions& options);
  void start_workers(std::uint32_t threads);
  void share_out();
  template <typename Ask>
  void collide_shared_selves(const Question<Ask>& question);
  template <typename Ask>
  void collide(const Question<Ask>& question);
  CrowdStats gather();
  void even_out();

  Sweep sweep_;
  std::uint64_t moved_ = 0;                      // instances since the last successful query
  std::vector<const SelfFilter*> self_filters_;  // of each instance, or null; empty if not asked
  std::vector<CrowdPair> self_tests_;            // pairs (i, i) to test
  std::vector<CrowdPair> pairs_;                 // pairs to test, after the self-tests
  Islands islands_;                              // of the pairs to test
  std::vector<CrowdPair> shared_selves_, shared_pairs_;  // of the large islands
  std::vector<std::uint32_t> small_islands_;             // all other islands
  WorkShares self_shares_, pair_shares_, island_shares_;
  std::vector<Worker> workers_;
  std::uint32_t worker_count_ = 1;  // of this query
  std::vector<TouchingPair> touching_;
  Workers threads_;
};

}  // namespace pelt::detail
