#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace pelt::detail {

/// Distributes the indices below a count to workers, in contiguous runs. A worker claims indices
/// from the front of its own run, and then from the ends of other runs. Neighbouring indices, which
/// share data, are therefore mostly processed by one worker, and seldom by two at once.
class WorkShares {
 public:
  /// Assigns the runs. Preconditions: no worker claims meanwhile, and `count` is less than 2^32.
  void deal(std::uint32_t count, std::uint32_t workers);

  /// Claims the next index; nullopt once all are claimed.
  std::optional<std::uint32_t> take(std::uint32_t worker);

 private:
  /// A run [begin, end) in one word, so that both ends change atomically.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> run{0};
  };

  enum class End { front, back };
  static std::optional<std::uint32_t> take_from(Share& share, End end);

  std::vector<Share> shares_;
  std::uint32_t worker_count_ = 0;
};

}  // namespace pelt::detail
