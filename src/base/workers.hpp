#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pelt::detail {

/// Threads that wait for jobs, each of which several of them do together. They are started when a
/// job first asks for them and end with this object.
class Workers {
 public:
  using Job = std::function<void(std::uint32_t worker)>;

  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// Calls `job(0)` on this thread and `job(1)` to `job(count - 1)` on others at the same time, and
  /// returns when all have. Where threads cannot be had, fewer workers are called, or 0 alone: a
  /// job must share its work so that any of them can do all of it.
  ///
  /// If workers throw, rethrows the first exception on this thread once all have ended.
  void run(std::uint32_t count, const Job& job);

  /// The threads that this machine runs at once, at least one.
  static std::uint32_t available();

 private:
  void start(std::uint32_t count);
  void call(const Job& job, std::uint32_t worker) noexcept;
  void wait_for_jobs(std::uint32_t worker);

  std::vector<std::thread> threads_;  // of the workers 1, 2, ...
  std::mutex mutex_;                  // of what follows
  std::condition_variable has_job_, is_done_;
  const Job* job_ = nullptr;
  std::uint64_t job_number_ = 0;
  std::uint32_t called_ = 0;   // workers that the job is for, 0 included
  std::uint32_t running_ = 0;  // of those, the ones that have not ended, without 0
  std::exception_ptr error_;   // the first of this job
  bool is_ending_ = false;
};

}  // namespace pelt::detail
