#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace pelt::detail {

/// Threads that execute jobs together. They are started when a job first needs them, and end with
/// this object.
class Workers {
 public:
  using Job = std::function<void(std::uint32_t worker)>;

  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// Calls `job(0)` on this thread and `job(1)` to `job(count - 1)` on other threads in parallel,
  /// and returns when all have returned. If threads cannot be started, calls fewer workers, or only
  /// worker 0, so any worker must be able to do all of the work.
  ///
  /// If workers throw, rethrows the first exception on this thread after all have returned.
  void run(std::uint32_t count, const Job& job);

  /// Number of threads that the machine runs in parallel, at least one.
  static std::uint32_t available();

  /// Returns `threads`, or `available()` if it is 0.
  static std::uint32_t count_or_available(std::uint32_t threads) {
    return threads > 0 ? threads : available();
  }

 private:
  void start(std::uint32_t count);
  void call(const Job& job, std::uint32_t worker) noexcept;
  void wait_for_jobs(std::uint32_t worker);

  std::vector<std::thread> threads_;  // of the workers 1, 2, ...
  std::mutex mutex_;                  // protects the members below
  std::condition_variable has_job_, is_done_;
  const Job* job_ = nullptr;
  std::uint64_t job_number_ = 0;
  std::uint32_t called_ = 0;   // workers of the job, including worker 0
  std::uint32_t running_ = 0;  // workers that have not returned yet, excluding worker 0
  std::exception_ptr error_;   // the first exception of the job
  bool is_ending_ = false;
};

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
