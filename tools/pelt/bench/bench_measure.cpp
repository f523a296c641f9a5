#include "tools/pelt/bench/bench_measure.hpp"

#include "tools/pelt/output/statistics.hpp"

#include <atomic>

namespace pelt::tools::bench {
namespace {

/// Reads more memory than the caches hold, on as many threads as the method has, because each core
/// has caches of its own. Stores the sum, so that the compiler does not remove the reads.
class CacheFlush {
 public:
  void run(std::uint32_t threads) {
    threads_.run(threads, [this](std::uint32_t) {
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < memory_.size(); i += kWordsPerCacheLine) sum += memory_[i];
      sum_ += sum;
    });
  }

 private:
  static constexpr std::size_t kWordsPerCacheLine = 8;

  std::vector<std::uint64_t> memory_ = std::vector<std::uint64_t>((64u << 20) / 8, 1);
  std::atomic<std::uint64_t> sum_ = 0;
  detail::Workers threads_;
};

/// The frame before `frame` in an animation. Scenes may loop, so the last frame comes before the
/// first.
std::uint32_t frame_before(std::uint32_t frame, const scenes::Scene& scene) {
  return frame == 0 ? scene.frame_count - 1 : frame - 1;
}

/// A frame and the previous one.
struct FramePair {
  scene::Palettes before, now;
};

struct FrameTime {
  double all_us = 0, update_us = 0;
};

/// Data shared by all repetitions.
struct Conditions {
  std::uint32_t repetitions = 1;
  Time time = Time::thread;
  CacheFlush flush;
};

/// Runs one repetition: the previous frame untimed, then this frame.
Result<FrameTime> repeat_once(Runner& runner, const FramePair& frame, const Variant& variant,
                              Conditions& conditions) {
  const bool update_counts = runner.update_counts();
  if (const auto posed = runner.pose(frame.before); !posed) return posed.error();
  runner.ask(variant.question);
  if (!update_counts) {
    if (const auto posed = runner.pose(frame.now); !posed) return posed.error();
  }
  if (variant.cache == Cache::cold) conditions.flush.run(runner.threads());
  Stopwatch watch(conditions.time);
  if (update_counts) {
    if (const auto posed = runner.pose(frame.now); !posed) return posed.error();
  }
  watch.lap();
  runner.ask(variant.question);
  watch.stop();
  return FrameTime{watch.microseconds(), watch.lap_microseconds()};
}

Result<FrameTime> median_time(Runner& runner, const FramePair& frame, const Variant& variant,
                              Conditions& conditions) {
  std::vector<double> all, update;
  for (std::uint32_t r = 0; r < conditions.repetitions; ++r) {
    const Result<FrameTime> time = repeat_once(runner, frame, variant, conditions);
    if (!time) return time.error();
    all.push_back(time->all_us);
    update.push_back(time->update_us);
  }
  return FrameTime{output::median(all), output::median(update)};
}

/// The frames of one variant of one method, one after the other.
class Series {
 public:
  void add(const FrameTime& time, bool is_in_contact) {
    all_.push_back(time.all_us);
    update_.push_back(time.update_us);
    if (is_in_contact) in_contact_.push_back(time.all_us);
  }

  Times times() const {
    return {output::mean(all_),
            output::mean(in_contact_),
            output::percentile(all_, 0.95),
            output::mean(update_),
            all_.size(),
            in_contact_.size()};
  }

 private:
  std::vector<double> all_, update_, in_contact_;
};

bool is_passed_over(std::size_t index, std::size_t frame_count, const Variant& variant) {
  const std::size_t stride = (frame_count + kMaxColdFrames - 1) / kMaxColdFrames;
  return variant.cache == Cache::cold && index % stride != 0;
}

/// Measures all methods on all frames.
class Measurement {
 public:
  Measurement(const Subject& subject, std::span<const BenchMethod> methods,
              std::span<const Variant> variants, std::uint32_t repetitions)
      : subject_(subject), variants_(variants) {
    conditions_.repetitions = repetitions;
    conditions_.time = time_of(methods);
    for (const BenchMethod& method : methods) runners_.emplace_back(subject.colliders, method);
    series_.assign(methods.size(), std::vector<Series>(variants.size()));
  }

  Result<void> run(const std::function<void()>& advance) {
    for (std::size_t i = 0; i < subject_.frames.size(); ++i) {
      const std::uint32_t frame = subject_.frames[i];
      scene::sample_palettes(subject_.scene, frame_before(frame, subject_.scene), scratch_,
                             frame_.before);
      scene::sample_palettes(subject_.scene, frame, scratch_, frame_.now);
      for (std::size_t method = 0; method < runners_.size(); ++method) {
        if (const auto done = measure_frame(i, method); !done) return in_frame(frame, done.error());
        advance();
      }
    }
    return {};
  }

  std::vector<std::vector<Times>> times() const {
    std::vector<std::vector<Times>> times;
    for (const std::vector<Series>& method : series_) {
      times.emplace_back();
      for (const Series& series : method) times.back().push_back(series.times());
    }
    return times;
  }

 private:
  Result<void> measure_frame(std::size_t index, std::size_t method) {
    Runner& runner = runners_[method];
    for (std::size_t v = 0; v < variants_.size(); ++v) {
      if (is_passed_over(index, subject_.frames.size(), variants_[v])) continue;
      const Result<FrameTime> time = median_time(runner, frame_, variants_[v], conditions_);
      if (!time) return time.error();
      series_[method][v].add(*time, !runner.found().contacts.empty());
    }
    return {};
  }

  const Subject& subject_;
  std::span<const Variant> variants_;
  Conditions conditions_;
  std::vector<Runner> runners_;
  std::vector<std::vector<Series>> series_;
  asset::SampleScratch scratch_;
  FramePair frame_;
};

}  // namespace

Result<std::vector<std::vector<Times>>> measure(const Subject& subject,
                                                std::span<const BenchMethod> methods,
                                                std::span<const Variant> variants,
                                                std::uint32_t repetitions,
                                                const std::function<void()>& advance) {
  Measurement measurement(subject, methods, variants, repetitions);
  if (const auto done = measurement.run(advance); !done) return done.error();
  return measurement.times();
}

}  // namespace pelt::tools::bench
