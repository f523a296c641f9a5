#pragma once

/// Computes items on several threads and hands them over in order.

#include <pelt/result.hpp>

#include "base/workers.hpp"
#include "tools/pelt/output/progress.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::tools::check {

/// Indices of items, from `begin` up to `end`, exclusive.
struct Indices {
  std::size_t begin = 0, end = 0;

  std::size_t count() const { return end - begin; }
};

/// Items 0, 1, ... below a count. `Item` is default-constructible, and reused.
template <typename Item>
class OrderedWork {
 public:
  /// Computes an item on a thread. `worker` is below the number of threads; each worker computes
  /// one item at a time.
  using Compute = std::function<Result<void>(std::uint32_t worker, std::size_t index, Item& item)>;

  /// Uses an item. Calls follow one another in the order of items, on any thread.
  using Use = std::function<Result<void>(Item& item)>;

  /// Prepares an item that is computed next. Calls follow one another in the order of items, on any
  /// thread, so they can read from one file.
  using Prepare = std::function<void(Item& item)>;

  /// At most four items per thread are in memory at a time.
  OrderedWork(std::size_t count, std::uint32_t threads, Compute compute, Use use,
              Prepare prepare = {})
      : count_(count),
        threads_(threads),
        prepare_(std::move(prepare)),
        compute_(std::move(compute)),
        use_(std::move(use)),
        slots_(std::size_t{4} * threads) {}

  /// Returns the first error in the order of items, whether of computing or of using. Nothing after
  /// it is used.
  Result<void> run() {
    detail::Workers workers;
    workers.run(threads_, [this](std::uint32_t worker) { work(worker); });
    if (error_) return *error_;
    return {};
  }

 private:
  struct Slot {
    Item item;
    std::optional<Result<void>> computed;  // nullopt: not yet
  };

  Slot& slot_of(std::size_t index) { return slots_[index % slots_.size()]; }

  /// Ends the work of all threads if one throws, so that none waits forever.
  struct EndOnThrow {
    OrderedWork& of;
    bool is_armed = true;

    ~EndOnThrow() {
      if (!is_armed) return;
      const std::lock_guard lock(of.mutex_);
      of.is_ended_ = true;
      of.has_space_.notify_all();
    }
  };

  void work(std::uint32_t worker) {
    EndOnThrow guard{*this};
    while (const std::optional<std::size_t> index = claim()) {
      Slot& slot = slot_of(*index);
      const Result<void> computed = compute_(worker, *index, slot.item);
      use_ready(slot, computed);
    }
    guard.is_armed = false;
  }

  /// Waits until the slot of the next item is free, and prepares it. Nullopt if no items are left.
  std::optional<std::size_t> claim() {
    std::unique_lock lock(mutex_);
    has_space_.wait(lock, [this] {
      return is_ended_ || claimed_ == count_ || claimed_ < used_ + slots_.size();
    });
    if (is_ended_ || claimed_ == count_) return std::nullopt;
    if (prepare_) prepare_(slot_of(claimed_).item);
    return claimed_++;
  }

  /// Stores a computed item. Then uses all items whose turn it is, unless another thread does so.
  /// Wakes waiting threads once per half of the slots, and at the end, because waking takes long.
  void use_ready(Slot& slot, const Result<void>& computed) {
    std::unique_lock lock(mutex_);
    slot.computed = computed;
    if (is_using_) return;
    is_using_ = true;
    while (!is_ended_ && used_ < count_ && slot_of(used_).computed) {
      Slot& next = slot_of(used_);
      lock.unlock();
      Result<void> used = *next.computed ? use_(next.item) : *next.computed;
      lock.lock();
      next.computed.reset();
      ++used_;
      if (!used) error_ = used.error();
      if (!used) is_ended_ = true;
      if (is_ended_ || used_ % (slots_.size() / 2) == 0) has_space_.notify_all();
    }
    is_using_ = false;
    has_space_.notify_all();
  }

  std::size_t count_;
  std::uint32_t threads_;
  Prepare prepare_;
  Compute compute_;
  Use use_;
  std::mutex mutex_;  // protects the members below, except items while they are computed or used
  std::condition_variable has_space_;
  std::vector<Slot> slots_;
  std::size_t claimed_ = 0, used_ = 0;
  bool is_using_ = false, is_ended_ = false;
  std::optional<Error> error_;
};

/// One of the threads that compute items, and the number of threads for each of its items.
struct ItemWorker {
  std::uint32_t number = 0, threads = 1;
};

/// Computes items on `threads` threads (0 means all cores) by `compute(worker, index, item)`, and
/// passes them to `use`, in order. Calls of `use` follow one another, but on any thread. Shows a
/// progress bar. Returns the first error in the order of items. If there are fewer items than
/// threads, each item gets several.
template <typename Item, typename Compute, typename Use>
Result<void> compute_in_order(const Indices& indices, std::uint32_t threads, const Compute& compute,
                              const Use& use) {
  threads = detail::Workers::count_or_available(threads);
  const auto workers =
      static_cast<std::uint32_t>(std::clamp<std::size_t>(indices.count(), 1, threads));
  output::Progress progress(indices.count());
  const auto compute_item = [&](std::uint32_t worker, std::size_t index, Item& item) {
    return compute(ItemWorker{worker, threads / workers}, indices.begin + index, item);
  };
  const auto pass_on = [&](Item& item) -> Result<void> {
    progress.advance();
    return use(item);
  };
  return OrderedWork<Item>(indices.count(), workers, compute_item, pass_on).run();
}

}  // namespace pelt::tools::check
