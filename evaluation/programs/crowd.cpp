#include "evaluation/programs/crowd.hpp"

#include "base/assert.hpp"
#include "scenes/creature/random.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

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

namespace {

// Distances of neighbours in a row, and of rows, in metres. People less than half a metre apart
// brush each other with arms and legs; here about one pair per ten walkers does.
constexpr double kNearest = 0.4, kFarthest = 1.2, kRow = 1.3;

/// `m`, rotated so that +z becomes `forward`, and translated.
Matrix4 placed(const Matrix4& m, float forward_x, float forward_z, float x, float z) {
  Matrix4 out = m;
  for (std::size_t column = 0; column < 4; ++column) {
    const float* in = &m.m[4 * column];
    out.m[4 * column] = forward_z * in[0] + forward_x * in[2];
    out.m[4 * column + 2] = forward_z * in[2] - forward_x * in[0];
  }
  out.m[12] += x;
  out.m[14] += z;
  return out;
}

}  // namespace

WalkPhases::WalkPhases(const asset::Asset& asset)
    : joint_count_(static_cast<std::uint32_t>(asset.joints.size())),
      palettes_(std::size_t{kCount} * asset.joints.size()) {
  const asset::Clip* clip = asset.find_clip("walk");
  if (clip == nullptr && !asset.clips.empty()) clip = asset.clips.data();
  const float duration = clip != nullptr ? clip->duration : 0;
  asset::SampleScratch scratch;
  for (std::uint32_t phase = 0; phase < kCount; ++phase) {
    const float seconds = duration * static_cast<float>(phase) / static_cast<float>(kCount);
    sample_palette(asset, clip, seconds, {}, scratch,
                   std::span(palettes_).subspan(std::size_t{phase} * joint_count_, joint_count_));
  }
}

std::vector<Matrix4> WalkPhases::samples() const {
  std::vector<Matrix4> samples;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::span<const Matrix4> palette = (*this)[i * kCount / 6];
    samples.insert(samples.end(), palette.begin(), palette.end());
  }
  return samples;
}

WalkingCrowd::WalkingCrowd(const WalkPhases& phases, std::uint32_t count, double metre)
    : phases_(phases) {
  scenes::SplitMix64 random(count);
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
  double x = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    x = i % side == 0 ? 0 : x + metre * random.between(kNearest, kFarthest);
    const double z = metre * kRow * (i / side);
    const double heading = random.between(0, 6.283185307179586);
    walkers_.push_back({static_cast<float>(x), static_cast<float>(z),
                        static_cast<float>(std::sin(heading)),
                        static_cast<float>(std::cos(heading)),
                        static_cast<std::uint32_t>(random.next() % WalkPhases::kCount)});
  }
}

void WalkingCrowd::pose(std::uint32_t frame, std::vector<Matrix4>& palettes) const {
  palettes.clear();
  for (const Walker& w : walkers_)
    for (const Matrix4& m : phases_[(w.phase + frame) % WalkPhases::kCount])
      palettes.push_back(placed(m, w.forward_x, w.forward_z, w.x, w.z));
}

}  // namespace pelt::programs
