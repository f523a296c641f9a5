#include "crowd/crowd_query.hpp"

#include "base/wide_code.hpp"
#include "query/sort_contacts.hpp"

#include <algorithm>
#include <functional>
#include <memory>

namespace pelt::detail {
namespace {

bool agree(const CrowdGroups& a, const CrowdGroups& b) {
  return (a.member_of & b.collides_with) != 0 && (b.member_of & a.collides_with) != 0;
}

/// Room for as much again as was used by all workers together, so that any of them can do the work
/// of all in a frame like this one. Memory that is not used is not touched, and so costs none.
void even_out(Arena& arena, std::size_t used) {
  if (arena.capacity() < used + used / 16) arena.reserve(used + used / 4);
}

}  // namespace

CrowdStats CrowdQuery::run(CrowdInstances& instances, const CrowdOptions& options,
                           std::uint32_t max_contacts) {
  const std::uint64_t moved = box_instances(instances);
  sweep_.find_pairs(pairs_);
  filter_pairs(instances, options);
  if (moved > 0) close_all(instances);
  start_workers(options.threads);
  make_room(instances);
  collide_pairs(instances, max_contacts);
  CrowdStats stats = gather();
  stats.work.refits += moved;
  even_out();
  return stats;
}

/// The number of those that have moved since the last query.
std::uint64_t CrowdQuery::box_instances(CrowdInstances& instances) {
  std::uint64_t moved = 0;
  sweep_.clear();
  for (std::uint32_t number = 0; number < instances.end(); ++number) {
    if (!instances.has(number)) continue;
    CrowdInstance& instance = instances[number];
    sweep_.add(number, instance.box);
    moved += instance.has_moved;
    instance.has_moved = false;
  }
  return moved;
}

void CrowdQuery::filter_pairs(CrowdInstances& instances, const CrowdOptions& options) {
  std::erase_if(pairs_, [&](const CrowdPair& pair) {
    const auto [a, b] = pair;
    return !agree(instances[a].groups, instances[b].groups) ||
           (options.filter && !options.filter(a, b));
  });
}

/// Nodes lie in the workers' arenas without regard to their instances, so all are closed as soon as
/// one instance has moved.
void CrowdQuery::close_all(CrowdInstances& instances) {
  for (const std::uint32_t number : near_) instances[number].may_open = false;
  near_.clear();
  for (Worker& worker : workers_) worker.nodes.clear();
}

void CrowdQuery::make_room(CrowdInstances& instances) {
  const auto make_room_for = [&](std::uint32_t number) {
    CrowdInstance& instance = instances[number];
    if (instance.may_open) return;
    instance.may_open = true;
    near_.push_back(number);
    const auto nodes = static_cast<std::uint32_t>(instance.model.detail().tree.nodes.size());
    instance.opened = OpenedNodes(nodes, workers_[0].nodes);
    instance.opened.root_box = instance.box;
  };
  for (const CrowdPair& pair : pairs_) {
    make_room_for(pair.instance_a);
    make_room_for(pair.instance_b);
  }
}

void CrowdQuery::start_workers(std::uint32_t threads) {
  if (threads == 0) threads = Workers::available();
  worker_count_ = static_cast<std::uint32_t>(std::clamp<std::size_t>(pairs_.size(), 1, threads));
  if (workers_.size() < worker_count_) workers_.resize(worker_count_);
  for (Worker& worker : workers_) {
    worker.contacts.clear();
    worker.touching.clear();
    worker.work = {};
  }
}

void CrowdQuery::collide_pairs(CrowdInstances& instances, std::uint32_t max_contacts) {
  shares_.deal(static_cast<std::uint32_t>(pairs_.size()), worker_count_);
  const auto job = [&](std::uint32_t worker) {
    while (const auto pair = shares_.take(worker))
      collide_pair(instances, pairs_[*pair], workers_[worker], max_contacts);
  };
  threads_.run(worker_count_, std::ref(job));
}

void CrowdQuery::collide_pair(CrowdInstances& instances, const CrowdPair& pair, Worker& worker,
                              std::uint32_t max_contacts) {
  const PosedTree a = instances[pair.instance_a].posed_tree(worker.nodes);
  const PosedTree b = instances[pair.instance_b].posed_tree(worker.nodes);
  worker.work += wide_code().collide_trees(a, b, worker.scratch, max_contacts);
  Stack<Contact>& found = worker.scratch.found;
  if (found.empty()) return;
  sort_contacts(found, worker.scratch.sorting);
  auto* kept = reinterpret_cast<Contact*>(worker.contacts.allocate(found.size() * sizeof(Contact)));
  std::uninitialized_copy(found.begin(), found.end(), kept);
  worker.touching.push_back({pair, {kept, found.size()}});
}

CrowdStats CrowdQuery::gather() {
  CrowdStats stats;
  touching_.clear();
  for (const Worker& worker : workers_) {
    touching_.insert(touching_.end(), worker.touching.begin(), worker.touching.end());
    stats.work += worker.work;
  }
  std::sort(touching_.begin(), touching_.end(),
            [](const TouchingPair& a, const TouchingPair& b) { return a.instances < b.instances; });
  stats.candidate_pairs = pairs_.size();
  stats.touching_pairs = touching_.size();
  return stats;
}

/// Which worker does which pairs is a matter of chance, and so would be who runs out of room.
void CrowdQuery::even_out() {
  if (worker_count_ == 1) return;
  std::size_t nodes = 0, contacts = 0, slot_pairs = 0, found = 0, sorting = 0;
  for (Worker& worker : workers_) {
    nodes += worker.nodes.used();
    contacts += worker.contacts.used();
    slot_pairs = std::max(slot_pairs, worker.scratch.slot_pairs.capacity());
    found = std::max(found, worker.scratch.found.capacity());
    sorting = std::max(sorting, worker.scratch.sorting.capacity());
  }
  for (std::uint32_t w = 0; w < worker_count_; ++w) {
    detail::even_out(workers_[w].nodes, nodes);
    detail::even_out(workers_[w].contacts, contacts);
    workers_[w].scratch.slot_pairs.reserve(slot_pairs);
    workers_[w].scratch.found.reserve(found);
    workers_[w].scratch.sorting.reserve(sorting);
    workers_[w].touching.reserve(touching_.size());
  }
}

std::size_t CrowdQuery::memory() const {
  std::size_t bytes = sweep_.memory() + pairs_.capacity() * sizeof(CrowdPair) +
                      near_.capacity() * sizeof(near_[0]) +
                      touching_.capacity() * sizeof(TouchingPair);
  for (const Worker& worker : workers_)
    bytes +=
        worker.nodes.capacity() + worker.contacts.capacity() +
        worker.touching.capacity() * sizeof(TouchingPair) +
        worker.scratch.slot_pairs.capacity() * sizeof(SlotPair) +
        (worker.scratch.found.capacity() + worker.scratch.sorting.capacity()) * sizeof(Contact);
  return bytes;
}

}  // namespace pelt::detail
