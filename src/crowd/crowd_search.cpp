#include "crowd/crowd_search.hpp"

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "collide/search.hpp"
#include "query/answers.hpp"
#include "query/sort_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace pelt::detail {
namespace {

/// In the order `first_contact`, a pair is decided by its first contact.
bool is_decided(const SearchState& state) {
  return state.items.count == 0 ||
         (state.order == SearchOrder::first_contact && !state.found.empty());
}

}  // namespace

CrowdStats CrowdSearch::run(CrowdInstances& instances, std::span<const CrowdPair> pairs,
                            const CrowdBudget& budget, std::uint32_t threads) {
  require(budget.slice > 0, "Crowd::search: the slice is 0; give 1 unit of work or more");
  threads = Workers::count_or_available(threads);
  workers_.resize(std::clamp<std::size_t>(pairs.size(), 1, threads));
  for (Worker& worker : workers_) {
    worker.nodes.clear();
    worker.work = {};
  }
  start(instances, pairs, budget);
  for (std::uint64_t done = 0; !active_.empty() && done < budget.work; done = work_done())
    run_round(instances, budget, budget.work - done);
  finish(instances);
  CrowdStats stats;
  for (const Worker& worker : workers_) stats += worker.work;
  stats.candidate_pairs = count_;
  for (const PairSearch& search : std::span(searches_).first(count_))
    stats.intersecting_pairs += !search.state.found.empty();
  stats.cut_short = !active_.empty();
  return stats;
}

void CrowdSearch::start(CrowdInstances& instances, std::span<const CrowdPair> pairs,
                        const CrowdBudget& budget) {
  count_ = pairs.size();
  if (searches_.size() < count_) searches_.resize(count_);
  active_.clear();
  for (std::uint32_t i = 0; i < count_; ++i) {
    PairSearch& search = searches_[i];
    const auto [a, b] = search.instances = pairs[i];
    search.weight = budget.weight ? budget.weight(a, b) : 0;
    require(!std::isnan(search.weight), "Crowd::search: the weight of a pair is NaN");
    search.state.order = budget.order;
    search.state.max_open = budget.max_open;
    workers_[0].work += start_search(instances[a].posed_tree(workers_[0].nodes),
                                     instances[b].posed_tree(workers_[0].nodes), search.state);
    search.started = search.state.work.done;
    if (!is_decided(search.state)) active_.push_back(i);
  }
  std::sort(active_.begin(), active_.end(), [this](std::uint32_t i, std::uint32_t k) {
    const PairSearch &a = searches_[i], &b = searches_[k];
    return a.weight != b.weight ? a.weight > b.weight : a.instances < b.instances;
  });
}

/// The work of all searches after they were started.
std::uint64_t CrowdSearch::work_done() const {
  std::uint64_t done = 0;
  for (const PairSearch& search : std::span(searches_).first(count_))
    done += search.state.work.done - search.started;
  return done;
}

/// Advances each undecided search by one slice, or the heaviest ones if `work` is less than that.
void CrowdSearch::run_round(CrowdInstances& instances, const CrowdBudget& budget,
                            std::uint64_t work) {
  const std::uint64_t whole = work / budget.slice, rest = work % budget.slice;
  const auto count =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(active_.size(), whole + (rest > 0)));
  const auto worker_count = static_cast<std::uint32_t>(workers_.size());
  shares_.deal(count, worker_count);
  const auto job = [&](std::uint32_t number) {
    Worker& worker = workers_[number];
    while (const auto next = shares_.take(number)) {
      PairSearch& search = searches_[active_[*next]];
      const auto [a, b] = search.instances;
      search.state.work.granted += *next < whole ? budget.slice : rest;
      worker.work += advance_search(instances[a].posed_tree(worker.nodes),
                                    instances[b].posed_tree(worker.nodes), search.state);
    }
  };
  threads_.run(worker_count, std::ref(job));
  std::erase_if(active_, [this](std::uint32_t i) { return is_decided(searches_[i].state); });
}

void CrowdSearch::finish(CrowdInstances& instances) {
  for (PairSearch& search : std::span(searches_).first(count_)) {
    sort_contacts(search.state.found, scratch_.sorting);
    instances[search.instances.instance_a].close();
    instances[search.instances.instance_b].close();
  }
}

void CrowdSearch::append_contacts(std::vector<CrowdContact>& contacts) const {
  std::vector<const PairSearch*> touching;
  std::size_t contact_count = 0;
  for (const PairSearch& search : std::span(searches_).first(count_))
    if (!search.state.found.empty()) {
      touching.push_back(&search);
      contact_count += search.state.found.size();
    }
  reserve_more(contacts, contact_count);
  std::sort(touching.begin(), touching.end(),
            [](const PairSearch* a, const PairSearch* b) { return a->instances < b->instances; });
  for (const PairSearch* search : touching)
    for (std::size_t i = 0; i < search->state.found.size(); ++i) {
      const Contact& contact = search->state.found.begin()[i];
      contacts.push_back({search->instances.instance_a, search->instances.instance_b,
                          contact.triangle_a, contact.triangle_b});
    }
}

void CrowdSearch::append_undecided(CrowdInstances& instances,
                                   std::vector<UndecidedPair>& undecided) const {
  const std::size_t first = undecided.size();
  for (const std::uint32_t i : active_) {
    const PairSearch& search = searches_[i];
    const auto [a, b] = search.instances;
    const SearchState& state = search.state;
    undecided.push_back(
        {search.instances, verdict_of(state),
         undecided_pairs(state, instances[a].model.detail().tree, instances[b].model.detail().tree),
         resolution_of(state), distance_bound(state)});
  }
  std::sort(
      undecided.begin() + static_cast<std::ptrdiff_t>(first), undecided.end(),
      [](const UndecidedPair& x, const UndecidedPair& y) { return x.instances < y.instances; });
}

std::size_t CrowdSearch::memory_bytes() const {
  std::size_t bytes = bytes_held(searches_, active_, workers_, scratch_.sorting);
  for (const PairSearch& search : searches_)
    bytes += bytes_held(search.state.items.pool, search.state.found, search.state.needed_a,
                        search.state.needed_b);
  for (const Worker& worker : workers_) bytes += worker.nodes.capacity();
  return bytes;
}

}  // namespace pelt::detail
