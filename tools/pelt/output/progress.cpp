#include "tools/pelt/output/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <string>

namespace pelt::tools::output {
namespace {

constexpr auto kPause = std::chrono::milliseconds(100);
constexpr std::size_t kWidth = 40;

std::atomic<bool> is_any_visible = false;

/// Whether the caller may show a bar. It must then reset `is_any_visible`.
bool claim_terminal() { return isatty(STDERR_FILENO) != 0 && !is_any_visible.exchange(true); }

}  // namespace

/// Delays the first drawing too, so that a short run shows no bar.
Progress::Progress(std::size_t total)
    : visible_(claim_terminal()),
      total_(std::max<std::size_t>(total, 1)),
      next_drawing_(Clock::now() + kPause) {}

Progress::~Progress() {
  if (!visible_) return;
  std::fprintf(stderr, "\r\033[K");
  is_any_visible = false;
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
