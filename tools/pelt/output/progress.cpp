#include "tools/pelt/output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace pelt::tools::output {
namespace {

constexpr auto kPause = std::chrono::milliseconds(100);
constexpr std::size_t kWidth = 40;

}  // namespace

/// Delays the first drawing too, so that a short run shows no bar.
Progress::Progress(std::size_t total)
    : visible_(isatty(STDERR_FILENO) != 0),
      total_(std::max<std::size_t>(total, 1)),
      next_drawing_(Clock::now() + kPause) {}

Progress::~Progress() {
  if (visible_) std::fprintf(stderr, "\r\033[K");
}

void Progress::advance() {
  ++done_;
  if (!visible_ || Clock::now() < next_drawing_) return;
  next_drawing_ = Clock::now() + kPause;
  const std::size_t filled = std::min(kWidth, kWidth * done_ / total_);
  const std::string bar = std::string(filled, '=') + std::string(kWidth - filled, ' ');
  std::fprintf(stderr, "\r[%s] %zu / %zu", bar.c_str(), done_, total_);
}

}  // namespace pelt::tools::output
