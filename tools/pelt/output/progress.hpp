#pragma once

#include <chrono>
#include <cstddef>

namespace pelt::tools::output {

/// A progress bar on standard error; silent if standard error is not a terminal. Of several bars at
/// a time, only the first one is shown.
class Progress {
 public:
  explicit Progress(std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< erases the bar

  void advance();

 private:
  using Clock = std::chrono::steady_clock;

  bool visible_;
  std::size_t done_ = 0, total_;
  Clock::time_point next_drawing_;
};

}  // namespace pelt::tools::output
