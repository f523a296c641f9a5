#pragma once

/// Runs a query for many frames on several threads.

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace pelt::python {

namespace py = pybind11;

/// How to run a call.
struct Run {
  std::uint32_t threads = 0;  ///< 0: one for each processor

  /// None, or a function that is called about ten times a second with the number of frames done.
  py::object on_progress = py::none();
};

namespace detail {
class SharedRun;
}

/// The frames of one thread.
class FrameQueue {
 public:
  FrameQueue(detail::SharedRun& run, bool is_caller) : run_(run), is_caller_(is_caller) {}

  /// Claims the next frame; nullopt once all are claimed, or if another thread has failed. On the
  /// thread of the caller, looks for Ctrl-C from time to time, and reports progress.
  std::optional<std::size_t> next();

  /// The frame that `next` has returned last.
  std::size_t current() const { return next_ - 1; }

 private:
  detail::SharedRun& run_;
  bool is_caller_;
  std::size_t next_ = 0, end_ = 0;
};

using Body = std::function<void(FrameQueue&)>;

/// Calls `body` on each thread; it must handle all frames that its queue gives out. Frames are
/// given out in ascending order, `block` consecutive frames at a time to one thread.
///
/// The caller holds the interpreter lock, which is released until the function returns. `body`
/// must therefore not touch Python's objects.
///
/// If threads throw, rethrows the exception of the lowest frame, whatever the number of threads.
void run_frames(std::size_t count, const Run& run, const Body& body, std::size_t block = 1);

}  // namespace pelt::python
