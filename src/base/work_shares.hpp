#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace pelt::detail {

/// The numbers below some count, dealt out to workers in runs of neighbours. A worker takes its own
/// run from the front; when it is through, it takes from the ends of the others'. So neighbours,
/// which have much in common, are mostly done by the same worker, and seldom by two at once.
class WorkShares {
 public:
  /// Precondition: no worker takes meanwhile, and `count` is less than 2^32.
  void deal(std::uint32_t count, std::uint32_t workers);

  /// A number that nobody has taken, or none: then all have been.
  std::optional<std::uint32_t> take(std::uint32_t worker);

 private:
  /// A run [begin, end) as one word, so that both ends are changed as one.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> run{0};
  };

  enum class End { front, back };
  static std::optional<std::uint32_t> take_from(Share& share, End end);

  std::vector<Share> shares_;
  std::uint32_t worker_count_ = 0;
};

}  // namespace pelt::detail
