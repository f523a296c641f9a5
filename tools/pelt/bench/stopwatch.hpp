#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

namespace pelt::tools::bench {

/// Kind of time that a stopwatch measures.
enum class Time {
  thread,  ///< CPU time of this thread
  wall,    ///< elapsed time, for several threads
};

/// Measures the time of one thread on a machine that runs other programs too: excludes time in
/// which the system runs something else instead. Two clocks run, wall time and the thread's
/// processor time, and the lesser counts: wall time includes the pauses, and reading the processor
/// time takes longer than some queries. With several threads, measures wall time only, because one
/// thread may wait while the others work.
class Stopwatch {
 public:
  explicit Stopwatch(Time time = Time::thread)
      : time_(time), processor_begin_(processor_us()), begin_(Clock::now()), lap_(begin_) {}

  /// Ends the first part.
  void lap() { lap_ = Clock::now(); }

  void stop() {
    end_ = Clock::now();
    processor_us_ = processor_us() - processor_begin_;
  }

  /// Time of both parts.
  double microseconds() const {
    const double wall = wall_us(end_);
    return time_ == Time::wall ? wall : std::min(wall, processor_us_);
  }

  /// Time of the first part.
  double lap_microseconds() const {
    const double all = wall_us(end_);
    return all > 0 ? microseconds() * (wall_us(lap_) / all) : 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double processor_us() {
    std::timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
  }

  double wall_us(Clock::time_point end) const {
    return std::chrono::duration<double, std::micro>(end - begin_).count();
  }

  Time time_;
  double processor_begin_, processor_us_ = 0;
  Clock::time_point begin_, lap_, end_;
};

}  // namespace pelt::tools::bench
