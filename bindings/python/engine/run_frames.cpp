#include "bindings/python/engine/run_frames.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

namespace pelt::python {

namespace detail {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kBetweenLooks = std::chrono::milliseconds(100);

}  // namespace

/// State that the threads of a call share.
class SharedRun {
 public:
  SharedRun(std::size_t count, std::size_t block, const py::object& on_progress)
      : count_(count), block_(block), on_progress_(on_progress) {}

  /// Claims a block of frames: first and end. Empty if there is nothing left to do.
  std::pair<std::size_t, std::size_t> claim() {
    if (has_failed_) return {};
    const std::size_t first = claimed_.fetch_add(block_);
    if (first >= count_) return {};
    return {first, std::min(first + block_, count_)};
  }

  void finish_frame() { ++done_; }

  /// Called on the thread of the caller, without the interpreter lock.
  void look_up() {
    const auto now = Clock::now();
    if (now - last_look_ < kBetweenLooks) return;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!on_progress_.is_none()) on_progress_(done_.load());
    last_look_ = Clock::now();
  }

  void execute(const Body& body, bool is_caller) noexcept {
    FrameQueue queue(*this, is_caller);
    try {
      body(queue);
    } catch (...) {
      fail(queue.current(), std::current_exception());
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void fail(std::size_t frame, std::exception_ptr error) noexcept {
    has_failed_ = true;
    const std::lock_guard lock(mutex_);
    if (error_ && frame >= failed_frame_) return;
    error_ = std::move(error);
    failed_frame_ = frame;
  }

  const std::size_t count_, block_;
  const py::object& on_progress_;
  Clock::time_point last_look_ = Clock::now();
  std::atomic<std::size_t> claimed_ = 0, done_ = 0;
  std::atomic<bool> has_failed_ = false;
  std::mutex mutex_;  // protects the members below
  std::exception_ptr error_;
  std::size_t failed_frame_ = 0;
};

namespace {

std::size_t thread_count(std::size_t frames, std::size_t block, std::uint32_t wanted) {
  const std::size_t threads = wanted > 0 ? wanted : std::thread::hardware_concurrency();
  return std::clamp<std::size_t>(threads, 1,
                                 std::max<std::size_t>(1, (frames + block - 1) / block));
}

}  // namespace
}  // namespace detail

std::optional<std::size_t> FrameQueue::next() {
  if (next_ > 0) run_.finish_frame();
  if (is_caller_) run_.look_up();
  if (next_ == end_) std::tie(next_, end_) = run_.claim();
  if (next_ == end_) {
    next_ = end_ = 0;
    return std::nullopt;
  }
  return next_++;
}

void run_frames(std::size_t count, const Run& run, const Body& body, std::size_t block) {
  detail::SharedRun shared(count, block, run.on_progress);
  {
    const py::gil_scoped_release unlocked;
    std::vector<std::jthread> others;
    try {
      for (std::size_t i = detail::thread_count(count, block, run.threads); i > 1; --i)
        others.emplace_back([&] { shared.execute(body, false); });
    } catch (const std::system_error&) {
      // The system has no more threads: those that have started do the work.
    }
    shared.execute(body, true);
  }
  shared.rethrow();
}

}  // namespace pelt::python
