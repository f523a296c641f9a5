#include "base/workers.hpp"
#include "base/exceptions.hpp"

#include <algorithm>
#include <utility>

namespace pelt::detail {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)

Workers::~Workers() = default;
void Workers::run(std::uint32_t, const Job& job) { job(0); }
std::uint32_t Workers::available() { return 1; }

#else

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  has_job_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::run(std::uint32_t count, const Job& job) {
  if (count > 1) start(count);
  count = std::min(count, static_cast<std::uint32_t>(threads_.size()) + 1);
  if (count <= 1) return job(0);
  {
    const std::lock_guard lock(mutex_);
    job_ = &job;
    ++job_number_;
    called_ = count;
    running_ = count - 1;
  }
  has_job_.notify_all();
  call(job, 0);
  std::unique_lock lock(mutex_);
  is_done_.wait(lock, [&] { return running_ == 0; });
  if (const std::exception_ptr error = std::exchange(error_, nullptr))
    std::rethrow_exception(error);
}

std::uint32_t Workers::available() { return std::max(1u, std::thread::hardware_concurrency()); }

/// The standard library throws if the system has no more threads, or no memory for them.
void Workers::start(std::uint32_t count) {
  PELT_TRY {
    while (threads_.size() + 1 < count) {
      const auto worker = static_cast<std::uint32_t>(threads_.size()) + 1;
      threads_.emplace_back([this, worker] { wait_for_jobs(worker); });
    }
  }
  PELT_CATCH_ALL {}
}

/// Stores an exception of the job on any thread, for the caller of `run`.
void Workers::call(const Job& job, std::uint32_t worker) noexcept {
  PELT_TRY { job(worker); }
  PELT_CATCH_ALL {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
  }
}

void Workers::wait_for_jobs(std::uint32_t worker) {
  std::unique_lock lock(mutex_);
  for (std::uint64_t done = 0;;) {
    has_job_.wait(lock, [&] { return is_ending_ || (job_number_ != done && worker < called_); });
    if (is_ending_) return;
    done = job_number_;
    const Job& job = *job_;
    lock.unlock();
    call(job, worker);
    lock.lock();
    if (--running_ == 0) is_done_.notify_one();
  }
}

#endif

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
