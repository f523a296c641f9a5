#include "base/work_shares.hpp"

namespace pelt::detail {
namespace {

std::uint64_t pack(std::uint64_t begin, std::uint64_t end) { return begin << 32 | end; }

}  // namespace

void WorkShares::deal(std::uint32_t count, std::uint32_t workers) {
  if (shares_.size() < workers) shares_ = std::vector<Share>(workers);
  worker_count_ = workers;
  const auto begin_of = [&](std::uint64_t worker) { return count * worker / workers; };
  for (std::uint32_t w = 0; w < workers; ++w)
    shares_[w].run.store(pack(begin_of(w), begin_of(w + 1)), std::memory_order_relaxed);
}

std::optional<std::uint32_t> WorkShares::take(std::uint32_t worker) {
  if (const auto own = take_from(shares_[worker], End::front)) return own;
  for (std::uint32_t other = 1; other < worker_count_; ++other)
    if (const auto theirs = take_from(shares_[(worker + other) % worker_count_], End::back))
      return theirs;
  return std::nullopt;
}

std::optional<std::uint32_t> WorkShares::take_from(Share& share, End end_to_take) {
  std::uint64_t run = share.run.load(std::memory_order_relaxed);
  for (;;) {
    const auto begin = static_cast<std::uint32_t>(run >> 32);
    const auto end = static_cast<std::uint32_t>(run);
    if (begin == end) return std::nullopt;
    const bool front = end_to_take == End::front;
    const std::uint64_t rest = front ? pack(begin + 1, end) : pack(begin, end - 1);
    if (share.run.compare_exchange_weak(run, rest, std::memory_order_relaxed))
      return front ? begin : end - 1;
  }
}

}  // namespace pelt::detail
