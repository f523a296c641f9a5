#pragma once

/// Collision searches of pairs of a crowd, in rounds of equal work. In each round, the threads
/// share the undecided pairs.
///
/// Answers do not depend on the number of threads: what a search finds depends on its work only,
/// and the work of a search does not depend on which nodes other searches have opened.

#include <pelt/crowd.hpp>

#include "base/arena.hpp"
#include "base/workers.hpp"
#include "collide/search.hpp"
#include "crowd/instances.hpp"
#include "query/scratch.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

class CrowdSearch {
 public:
  /// Searches these pairs. Precondition: no node of an instance is open.
  CrowdStats run(CrowdInstances& instances, std::span<const CrowdPair> pairs,
                 const CrowdBudget& budget, std::uint32_t threads);

  /// Appends the contacts of the last run, ascending.
  void append_contacts(std::vector<CrowdContact>& contacts) const;

  /// Appends the pairs that the last run has not decided, ascending.
  void append_undecided(CrowdInstances& instances, std::vector<UndecidedPair>& undecided) const;

  std::size_t memory_bytes() const;

 private:
  struct PairSearch {
    CrowdPair instances;
    double weight = 0;
    std::uint64_t started = 0;  ///< work of starting, which is not limited
    SearchState state;
  };

  /// Memory of one thread.
  struct alignas(64) Worker {
    Arena nodes;
    QueryStats work;
  };

  void start(CrowdInstances& instances, std::span<const CrowdPair> pairs,
             const CrowdBudget& budget);
  std::uint64_t work_done() const;
  void run_round(CrowdInstances& instances, const CrowdBudget& budget, std::uint64_t work);
  void finish(CrowdInstances& instances);

  std::vector<PairSearch> searches_;  // the first `count_`, in the order of the pairs
  std::size_t count_ = 0;
  std::vector<std::uint32_t> active_;  // undecided searches, by descending weight
  std::vector<Worker> workers_;
  WorkShares shares_;
  Scratch scratch_;
  Workers threads_;
};

}  // namespace pelt::detail
