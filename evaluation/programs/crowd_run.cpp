#include "evaluation/programs/crowd_run.hpp"

#include "base/assert.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <algorithm>
#include <chrono>

namespace pelt::programs {
namespace {

using tools::output::median;

using Clock = std::chrono::steady_clock;

double ms_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

}  // namespace

CrowdRun::CrowdRun(const CrowdJob& job) : job_(job) {
  std::size_t first = 0;
  for (const SkinnedModel& model : job.models) {
    crowd_.add(model);
    firsts_.push_back(first);
    first += model.joint_count();
  }
  firsts_.push_back(first);
}

CrowdTiming CrowdRun::run(std::uint32_t threads) {
  std::vector<double> palettes_ms, frame_ms;
  CrowdTiming timing;
  for (std::uint32_t frame = 0; frame < job_.frame_count; ++frame) {
    timing = time_frame(frame, threads);
    palettes_ms.push_back(timing.palettes_ms);
    frame_ms.push_back(timing.frame_ms);
  }
  timing.palettes_ms = median(palettes_ms);
  timing.frame_ms = median(frame_ms);
  return timing;
}

CrowdTiming CrowdRun::best_of(std::uint32_t runs, std::uint32_t threads) {
  CrowdTiming best = run(threads);
  for (std::uint32_t r = 1; r < runs; ++r)
    best = std::min(best, run(threads), [](const CrowdTiming& a, const CrowdTiming& b) {
      return a.frame_ms < b.frame_ms;
    });
  return best;
}

CrowdTiming CrowdRun::time_frame(std::uint32_t frame, std::uint32_t threads) {
  job_.pose(frame, palettes_);
  contacts_.clear();
  CrowdTiming timing;
  const auto begin = Clock::now();
  set_palettes(threads);
  const auto posed = Clock::now();
  timing.stats = crowd_.collide(contacts_, {.threads = threads});
  const auto end = Clock::now();
  timing.palettes_ms = ms_between(begin, posed);
  timing.frame_ms = ms_between(begin, end);
  timing.contacts = contacts_.size();
  return timing;
}

void CrowdRun::set_palettes(std::uint32_t threads) {
  shares_.deal(static_cast<std::uint32_t>(job_.models.size()), threads);
  threads_.run(threads, [&](std::uint32_t thread) {
    while (const auto instance = shares_.take(thread)) set_palette(*instance);
  });
}

void CrowdRun::set_palette(std::uint32_t instance) {
  const std::size_t first = firsts_[instance];
  const std::span<const Matrix4> all = palettes_;
  const auto taken =
      crowd_.set_palette(instance, all.subspan(first, firsts_[instance + 1] - first));
  PELT_ASSERT(taken);
}

}  // namespace pelt::programs
