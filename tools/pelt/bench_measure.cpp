#include "tools/pelt/bench_measure.hpp"

#include "asset/message.hpp"
#include "tools/pelt/contact_hash.hpp"
#include "tools/pelt/statistics.hpp"

#include <algorithm>
#include <chrono>

namespace pelt::tools {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::micro>(duration).count();
}

CollideOptions options_for(Question question) {
  CollideOptions options;
  if (question == Question::first) options.max_contacts = 1;
  return options;
}

/// Which contact is found first is unspecified, so the hash is over who touches whom.
void add_hits(std::uint32_t frame, std::size_t collider_count, const FrameContacts& found,
              detail::Fnv1a64& hash) {
  auto pair = found.pairs.begin();
  for (std::uint32_t a = 0; a < collider_count; ++a) {
    for (std::uint32_t b = a + 1; b < collider_count; ++b) {
      const bool hit = pair != found.pairs.end() && pair->a == a && pair->b == b;
      if (hit) ++pair;
      for (const std::uint32_t value : {frame, a, b, std::uint32_t{hit}}) hash.add_u32(value);
    }
  }
}

/// Reads more memory than the caches hold. The sum is kept so that nothing is optimised away.
class CacheFlush {
 public:
  void run() {
    for (const std::uint64_t word : memory_) sum_ = sum_ + word;
  }

 private:
  std::vector<std::uint64_t> memory_ = std::vector<std::uint64_t>((64u << 20) / 8, 1);
  volatile std::uint64_t sum_ = 0;
};

/// One method with a scene to run it on.
class Bench {
 public:
  Bench(std::span<const Collider> colliders, bench::MethodKind method, Question question)
      : query_(colliders, method), options_(options_for(question)) {}

  Result<void> pose(const Palettes& palettes) { return query_.set_palettes(palettes); }
  void ask() { query_.collide(options_, found_); }

  const FrameContacts& found() const { return found_; }
  QueryStats work() const { return query_.work(); }

 private:
  SceneQuery query_;
  CollideOptions options_;
  FrameContacts found_;
};

struct FrameTime {
  double all_us = 0, update_us = 0;
};

/// One repetition: the frame before untimed, then this one.
Result<FrameTime> repeat_once(Bench& bench, const Palettes& before, const Palettes& now,
                              CacheFlush* flush) {
  if (const auto posed = bench.pose(before); !posed) return posed.error();
  bench.ask();
  if (flush != nullptr) flush->run();
  const Clock::time_point begin = Clock::now();
  if (const auto posed = bench.pose(now); !posed) return posed.error();
  const Clock::time_point posed_at = Clock::now();
  bench.ask();
  const Clock::time_point end = Clock::now();
  return FrameTime{microseconds(end - begin), microseconds(posed_at - begin)};
}

Result<FrameTime> median_time(Bench& bench, const Palettes& before, const Palettes& now,
                              std::uint32_t repetitions, CacheFlush* flush) {
  std::vector<double> all, update;
  for (std::uint32_t r = 0; r < repetitions; ++r) {
    const Result<FrameTime> time = repeat_once(bench, before, now, flush);
    if (!time) return time.error();
    all.push_back(time->all_us);
    update.push_back(time->update_us);
  }
  return FrameTime{median(all), median(update)};
}

}  // namespace

Result<Measurement> answer_once(const scenes::Scene& scene, std::span<const Collider> colliders,
                                bench::MethodKind method, const FrameRange& frames,
                                Question question) {
  Bench bench(colliders, method, question);
  asset::SampleScratch scratch;
  Palettes palettes;
  ContactHash contacts;
  detail::Fnv1a64 hits;
  Measurement measurement;
  for (const std::uint32_t frame : frames.frames()) {
    sample_palettes(scene, frame, scratch, palettes);
    const auto posed = bench.pose(palettes);
    if (!posed) return asset::prefixed("frame " + std::to_string(frame), posed.error());
    bench.ask();
    contacts.add(frame, bench.found());
    add_hits(frame, colliders.size(), bench.found(), hits);
    ++measurement.frames;
    measurement.frames_in_contact += !bench.found().contacts.empty();
  }
  measurement.hash = question == Question::all ? contacts.value() : hits.value();
  measurement.work = bench.work();
  return measurement;
}

Result<void> measure(const scenes::Scene& scene, std::span<const Collider> colliders,
                     bench::MethodKind method, const FrameRange& frames,
                     const BenchSettings& settings, const std::function<void()>& advance,
                     Measurement& measurement) {
  Bench bench(colliders, method, settings.question);
  std::optional<CacheFlush> flush;
  if (settings.cache == Cache::cold) flush.emplace();
  asset::SampleScratch scratch;
  Palettes before, now;
  std::vector<double> all, in_contact, update;
  for (const std::uint32_t frame : frames.frames()) {
    sample_palettes(scene, std::max(frame, 1u) - 1, scratch, before);
    sample_palettes(scene, frame, scratch, now);
    const Result<FrameTime> time =
        median_time(bench, before, now, settings.repetitions, flush ? &*flush : nullptr);
    if (!time) return asset::prefixed("frame " + std::to_string(frame), time.error());
    all.push_back(time->all_us);
    update.push_back(time->update_us);
    if (!bench.found().contacts.empty()) in_contact.push_back(time->all_us);
    advance();
  }
  measurement.mean_us = mean(all);
  measurement.mean_contact_us = mean(in_contact);
  measurement.p95_us = percentile(all, 0.95);
  measurement.mean_update_us = mean(update);
  return {};
}

}  // namespace pelt::tools
