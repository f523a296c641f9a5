#include "crowd/crowd_query.hpp"

#include "base/assert.hpp"
#include "base/bytes_held.hpp"
#include "collide/collide_trees.hpp"
#include "motion/moving_tree.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_filter.hpp"
#include "self/self_tree.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace pelt::detail {
namespace {

bool agree(const CollisionMask& a, const CollisionMask& b) {
  return (a.member_of & b.collides_with) != 0 && (b.member_of & a.collides_with) != 0;
}

bool is_self(const CrowdPair& pair) { return pair.instance_a == pair.instance_b; }

/// Applies an action to both instances of each pair.
template <typename Action>
void for_both(CrowdInstances& instances, std::span<const CrowdPair> pairs, const Action& action) {
  for (const CrowdPair& pair : pairs) {
    action(instances[pair.instance_a]);
    action(instances[pair.instance_b]);
  }
}

RootBox united(RootBox box, const RootBox& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], other.low[axis]);
    box.high[axis] = std::max(box.high[axis], other.high[axis]);
  }
  return box;
}

/// Prefetches a palette, which is probably no longer in the caches, and whose joints are read in no
/// particular order.
void prefetch_palette(const CrowdInstance& instance) {
  for (const Matrix4& joint : instance.palette.joints()) __builtin_prefetch(&joint);
  for (const DualQuaternion& joint : instance.palette.duals()) __builtin_prefetch(&joint);
}

/// Reserves as much memory as all workers used together, so that any worker could do all the work
/// of a similar frame. Reserves more than that when it must, so that frames that differ a little
/// seldom allocate. Memory that is never touched costs nothing.
void even_out(Arena& arena, std::size_t used) {
  if (arena.room() < used + used / 16) arena.reserve(used + used / 4);
}

/// The largest capacity of each stack of several scratches.
class StackCapacities {
 public:
  void add(const Scratch& scratch) {
    std::size_t i = 0;
    Scratch::each(scratch, [&](const auto& stack) {
      most_[i] = std::max(most_[i], stack.capacity());
      ++i;
    });
  }

  void reserve(Scratch& scratch) const {
    std::size_t i = 0;
    Scratch::each(scratch, [&](auto& stack) { stack.reserve(most_[i++]); });
  }

 private:
  std::array<std::size_t, Scratch::kStackCount> most_ = {};
};

/// Asks for contacts in the poses.
struct AskStill {
  static constexpr bool kInStep = false;
  static constexpr auto kFound = &Scratch::found, kSorting = &Scratch::sorting;
  static constexpr auto kKept = &TouchingPair::contacts;

  std::uint32_t max_contacts;

  static PosedTree view(CrowdInstances& instances, std::uint32_t number, Arena& arena) {
    return instances[number].posed_tree(arena);
  }

  QueryStats collide(const PosedTree& a, const PosedTree& b, Scratch& scratch) const {
    return collide_trees(a, b, scratch, max_contacts);
  }

  SelfStats collide_self(const PosedTree& posed, const SelfFilter& filter, Scratch& scratch) const {
    return self_collide_tree(posed, filter, nullptr, scratch, max_contacts);
  }
};

/// Asks for contacts at any time of the step.
struct AskMoving {
  static constexpr bool kInStep = true;
  static constexpr auto kFound = &Scratch::moving, kSorting = &Scratch::sorting_moving;
  static constexpr auto kKept = &TouchingPair::moving;

  const MovingOptions& options;

  static Step view(CrowdInstances& instances, std::uint32_t number, Arena& arena) {
    return {instances[number].start_tree(instances.moves(number), arena),
            instances[number].posed_tree(arena)};
  }

  MovingStats collide(const Step& a, const Step& b, Scratch& scratch) const {
    return collide_moving_trees(a.tree(), b.tree(), scratch, options);
  }

  SelfMovingStats collide_self(const Step& step, const SelfFilter& filter, Scratch& scratch) const {
    return self_collide_moving_tree(step.tree(), filter, scratch, options);
  }
};

}  // namespace

CrowdStats CrowdQuery::run(CrowdInstances& instances, const CrowdOptions& options,
                           std::uint32_t max_contacts) {
  return answer(instances, options, AskStill{max_contacts});
}

CrowdStats CrowdQuery::run_moving(CrowdInstances& instances, const CrowdOptions& options,
                                  const MovingOptions& moving) {
  return answer(instances, options, AskMoving{moving});
}

std::span<const CrowdPair> CrowdQuery::find_pairs(CrowdInstances& instances,
                                                  const CrowdOptions& options, QueryStats& work) {
  box_instances(instances, false);
  sweep_.find_pairs(pairs_);
  filter_pairs(instances, options);
  work.refits += std::exchange(moved_, 0);
  return pairs_;
}

template <typename Ask>
CrowdStats CrowdQuery::answer(CrowdInstances& instances, const CrowdOptions& options,
                              const Ask& ask) {
  box_instances(instances, Ask::kInStep);
  sweep_.find_pairs(pairs_);
  filter_pairs(instances, options);
  add_self_tests(instances, options);
  islands_.form(pairs_, instances.end());
  start_workers(options.threads);
  share_out();
  const Question<Ask> question = {instances, self_filters_, ask};
  collide_shared_selves(question);
  collide(question);
  CrowdStats stats = gather();
  stats.refits += std::exchange(moved_, 0);
  even_out();
  return stats;
}

/// Also closes the nodes, because a query that ran out of memory may have left some open.
void CrowdQuery::box_instances(CrowdInstances& instances, bool in_step) {
  sweep_.clear();
  for (std::uint32_t number = 0; number < instances.end(); ++number) {
    if (!instances.has(number)) continue;
    CrowdInstance& instance = instances[number];
    const bool moves = in_step && instances.moves(number);
    sweep_.add(number,
               moves ? united(instance.root_box, instance.start->root_box) : instance.root_box);
    moved_ += instance.has_moved;
    instance.has_moved = false;
    instance.close();
  }
}

void CrowdQuery::filter_pairs(CrowdInstances& instances, const CrowdOptions& options) {
  std::erase_if(pairs_, [&](const CrowdPair& pair) {
    const auto [a, b] = pair;
    return !agree(instances[a].mask, instances[b].mask) ||
           (options.filter && !options.filter(a, b));
  });
}

/// Puts the self-tests before all other pairs. Islands keep this order.
void CrowdQuery::add_self_tests(CrowdInstances& instances, const CrowdOptions& options) {
  self_filters_.clear();
  self_tests_.clear();
  if (!options.self_filter) return;
  self_filters_.resize(instances.end());
  for (std::uint32_t number = 0; number < instances.end(); ++number) {
    if (!instances.has(number)) continue;
    const pelt::SelfFilter* const filter = options.self_filter(number);
    if (!filter) continue;
    require(&filter->model().detail() == &instances[number].model.detail(),
            "Crowd: self_filter returned a filter of another model than that of the instance");
    self_filters_[number] = &filter->detail();
    self_tests_.push_back({number, number});
  }
  pairs_.insert(pairs_.begin(), self_tests_.begin(), self_tests_.end());
}

void CrowdQuery::start_workers(std::uint32_t threads) {
  threads = Workers::count_or_available(threads);
  worker_count_ = static_cast<std::uint32_t>(std::clamp<std::size_t>(pairs_.size(), 1, threads));
  if (workers_.size() < worker_count_) workers_.resize(worker_count_);
  for (Worker& worker : workers_) worker.clear();
}

void CrowdQuery::Worker::clear() {
  nodes.clear();
  shared_nodes.clear();
  contacts.clear();
  most_nodes = 0;
  touching.clear();
  work = {};
  left_out = {};
}

/// An island is large if it is a considerable part of the work of each worker.
void CrowdQuery::share_out() {
  const std::size_t large = worker_count_ == 1 ? pairs_.size() : pairs_.size() / worker_count_ / 8;
  shared_selves_.clear();
  shared_pairs_.clear();
  small_islands_.clear();
  for (std::uint32_t g = 0; g < islands_.count(); ++g) {
    const std::span<const CrowdPair> island = islands_[g];
    if (island.size() <= large) {
      small_islands_.push_back(g);
      continue;
    }
    const auto first_pair = std::partition_point(island.begin(), island.end(), is_self);
    shared_selves_.insert(shared_selves_.end(), island.begin(), first_pair);
    shared_pairs_.insert(shared_pairs_.end(), first_pair, island.end());
  }
  self_shares_.deal(static_cast<std::uint32_t>(shared_selves_.size()), worker_count_);
  pair_shares_.deal(static_cast<std::uint32_t>(shared_pairs_.size()), worker_count_);
  island_shares_.deal(static_cast<std::uint32_t>(small_islands_.size()), worker_count_);
}

/// Returns when all of these tests are done, before other tests use the nodes.
template <typename Ask>
void CrowdQuery::collide_shared_selves(const Question<Ask>& question) {
  if (shared_selves_.empty()) return;
  const auto job = [&](std::uint32_t number) {
    Worker& worker = workers_[number];
    while (const auto self = self_shares_.take(number))
      worker.collide_self(question, shared_selves_[*self].instance_a, worker.shared_nodes);
  };
  threads_.run(worker_count_, std::ref(job));
}

template <typename Ask>
void CrowdQuery::collide(const Question<Ask>& question) {
  CrowdInstances& instances = question.instances;
  for_both(instances, shared_pairs_, [this](CrowdInstance& instance) {
    make_table(instance.posed_tree(workers_[0].shared_nodes));
    if (instance.start) make_table(instance.start_tree(true, workers_[0].shared_nodes));
  });
  const auto job = [&](std::uint32_t number) {
    Worker& worker = workers_[number];
    while (const auto pair = pair_shares_.take(number))
      worker.collide_pair(question, shared_pairs_[*pair], worker.shared_nodes);
    const auto take_island = [&] {
      const auto island = island_shares_.take(number);
      return island ? islands_[small_islands_[*island]] : std::span<const CrowdPair>();
    };
    for (auto island = take_island(), next = island; !island.empty(); island = next) {
      next = take_island();
      for_both(instances, next, prefetch_palette);
      worker.collide_island(question, island);
    }
  };
  threads_.run(worker_count_, std::ref(job));
  const auto close = [](CrowdInstance& instance) { instance.close(); };
  for_both(instances, shared_selves_, close);
  for_both(instances, shared_pairs_, close);
}

template <typename Ask>
void CrowdQuery::Worker::collide_island(const Question<Ask>& question,
                                        std::span<const CrowdPair> island) {
  for (const CrowdPair& pair : island)
    is_self(pair) ? collide_self(question, pair.instance_a, nodes)
                  : collide_pair(question, pair, nodes);
  for_both(question.instances, island, [](CrowdInstance& instance) { instance.close(); });
  most_nodes = std::max(most_nodes, nodes.used());
  nodes.clear();
}

template <typename Ask>
void CrowdQuery::Worker::collide_pair(const Question<Ask>& question, const CrowdPair& pair,
                                      Arena& arena) {
  const auto a = Ask::view(question.instances, pair.instance_a, arena);
  const auto b = Ask::view(question.instances, pair.instance_b, arena);
  work += question.ask.collide(a, b, scratch);
  keep_found<Ask>(pair);
}

template <typename Ask>
void CrowdQuery::Worker::collide_self(const Question<Ask>& question, std::uint32_t instance,
                                      Arena& arena) {
  const auto stats = question.ask.collide_self(Ask::view(question.instances, instance, arena),
                                               *question.self_filters[instance], scratch);
  work += stats;
  left_out += stats.left_out;
  keep_found<Ask>({instance, instance});
}

/// Copies the contacts of a pair, if it has any, ascending.
template <typename Ask>
void CrowdQuery::Worker::keep_found(const CrowdPair& pair) {
  auto& found = scratch.*Ask::kFound;
  if (found.empty()) return;
  sort_contacts(found, scratch.*Ask::kSorting);
  using AnyContact = std::remove_reference_t<decltype(*found.begin())>;
  auto* kept = reinterpret_cast<AnyContact*>(contacts.allocate(found.size() * sizeof(AnyContact)));
  std::uninitialized_copy(found.begin(), found.end(), kept);
  TouchingPair& added = touching.emplace_back();
  added.instances = pair;
  added.*Ask::kKept = {kept, found.size()};
}

CrowdStats CrowdQuery::gather() {
  CrowdStats stats;
  touching_.clear();
  for (const Worker& worker : workers_) {
    touching_.insert(touching_.end(), worker.touching.begin(), worker.touching.end());
    stats += worker.work;
    stats.left_out += worker.left_out;
  }
  std::sort(touching_.begin(), touching_.end(),
            [](const TouchingPair& a, const TouchingPair& b) { return a.instances < b.instances; });
  stats.self_tests = self_tests_.size();
  stats.candidate_pairs = pairs_.size() - self_tests_.size();
  stats.self_intersecting = static_cast<std::uint64_t>(
      std::count_if(touching_.begin(), touching_.end(),
                    [](const TouchingPair& pair) { return is_self(pair.instances); }));
  stats.intersecting_pairs = touching_.size() - stats.self_intersecting;
  return stats;
}

/// Distributes memory evenly, because it is random which worker processes which pairs.
void CrowdQuery::even_out() {
  if (worker_count_ == 1) return;
  std::size_t shared_nodes = 0, nodes = 0, contacts = 0, boxes = 0;
  StackCapacities stacks;
  for (const Worker& worker : workers_) {
    shared_nodes += worker.shared_nodes.used();
    nodes = std::max(nodes, worker.most_nodes);
    contacts += worker.contacts.used();
    boxes = std::max(boxes, worker.scratch.boxes.room());
    stacks.add(worker.scratch);
  }
  for (std::uint32_t w = 0; w < worker_count_; ++w) {
    Worker& worker = workers_[w];
    detail::even_out(worker.shared_nodes, shared_nodes);
    detail::even_out(worker.nodes, nodes);
    detail::even_out(worker.contacts, contacts);
    worker.scratch.boxes.reserve(boxes);
    stacks.reserve(worker.scratch);
    worker.touching.reserve(touching_.size());
  }
}

std::size_t CrowdQuery::memory_bytes() const {
  std::size_t bytes = sweep_.memory_bytes() + islands_.memory_bytes() +
                      bytes_held(self_filters_, self_tests_, pairs_, shared_selves_, shared_pairs_,
                                 small_islands_, touching_, workers_);
  for (const Worker& worker : workers_) bytes += worker.memory_bytes();
  return bytes;
}

std::size_t CrowdQuery::Worker::memory_bytes() const {
  std::size_t bytes = nodes.capacity() + shared_nodes.capacity() + contacts.capacity() +
                      scratch.boxes.capacity() + bytes_held(touching);
  Scratch::each(scratch, [&](const auto& stack) { bytes += bytes_held(stack); });
  return bytes;
}

}  // namespace pelt::detail
