/// crowd_scaling [MODEL.glb | SCENE.json] [METRE]
///
/// How the time of a frame grows with the crowd: 100, 1,000 and 10,000 walking instances of a
/// character (the generated one, unless a file is named), on one thread and on two. Or the
/// instances of a scene. A frame is all palettes set, on as many threads, and all contacts found;
/// sampling the clips is not counted. Times are medians over the frames. METRE is the unit of the
/// distances between walkers: 1 unless said, and 1.9 for the generated character, which holds its
/// arms wide.

#include <pelt/crowd.hpp>

#include "base/workers.hpp"
#include "bench/walking_crowd.hpp"
#include "scenes/scene.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include <sys/resource.h>

namespace pelt::bench {
namespace {

/// What is posed and asked.
struct Job {
  std::vector<SkinnedModel> models;  ///< of each instance
  std::uint32_t frame_count = 0;
  std::function<void(std::uint32_t frame, std::vector<Matrix4>& palettes)> pose;
};

struct Timing {
  double palettes_ms = 0, frame_ms = 0;
  CrowdStats stats;
  std::size_t contacts = 0;
};

double ms_between(std::chrono::steady_clock::time_point begin,
                  std::chrono::steady_clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

class CrowdRun {
 public:
  explicit CrowdRun(const Job& job) : job_(job) {
    std::size_t first = 0;
    for (const SkinnedModel& model : job.models) {
      crowd_.add(model);
      firsts_.push_back(first);
      first += model.joint_count();
    }
    firsts_.push_back(first);
  }

  /// Medians and, of the counts, the first frame's.
  Timing run(std::uint32_t threads) {
    std::vector<double> palettes_ms, frame_ms;
    Timing first;
    for (std::uint32_t frame = 0; frame < job_.frame_count; ++frame) {
      const Timing timing = time_frame(frame, threads);
      palettes_ms.push_back(timing.palettes_ms);
      frame_ms.push_back(timing.frame_ms);
      if (frame == 0) first = timing;
    }
    first.palettes_ms = median(palettes_ms);
    first.frame_ms = median(frame_ms);
    return first;
  }

  std::size_t memory() const { return crowd_.memory(); }

 private:
  static double median(std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  }

  Timing time_frame(std::uint32_t frame, std::uint32_t threads) {
    job_.pose(frame, palettes_);
    contacts_.clear();
    const auto begin = std::chrono::steady_clock::now();
    set_palettes(threads);
    const auto posed = std::chrono::steady_clock::now();
    Timing timing;
    timing.stats = crowd_.collide(contacts_, {.threads = threads});
    timing.palettes_ms = ms_between(begin, posed);
    timing.frame_ms = ms_between(begin, std::chrono::steady_clock::now());
    timing.contacts = contacts_.size();
    return timing;
  }

  void set_palettes(std::uint32_t threads) {
    const std::size_t count = job_.models.size();
    threads_.run(threads, [&](std::uint32_t thread) {
      for (std::size_t i = count * thread / threads; i < count * (thread + 1) / threads; ++i) {
        const std::size_t first = firsts_[i];
        const Result<void> taken = crowd_.set_palette(
            static_cast<std::uint32_t>(i),
            std::span<const Matrix4>(palettes_).subspan(first, firsts_[i + 1] - first));
        if (!taken) std::printf("%s\n", taken.error().message.c_str());
      }
    });
  }

  const Job& job_;
  Crowd crowd_;
  std::vector<std::size_t> firsts_;  // of each instance, into palettes_
  std::vector<Matrix4> palettes_;
  std::vector<CrowdContact> contacts_;
  detail::Workers threads_;
};

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void print_head() {
  std::printf(
      "instances  1 thread ms  2 threads ms  (palettes)  candidates  touching  contacts"
      "  crowd MB  process MB\n");
}

void print_row(const Job& job) {
  CrowdRun run(job);
  run.run(2);
  const Timing one = run.run(1), two = run.run(2);
  std::printf("%9zu  %11.3f  %12.3f  %10.3f  %10llu  %8llu  %8zu  %8.1f  %10.1f\n",
              job.models.size(), one.frame_ms, two.frame_ms, two.palettes_ms,
              static_cast<unsigned long long>(two.stats.candidate_pairs),
              static_cast<unsigned long long>(two.stats.touching_pairs), two.contacts,
              static_cast<double>(run.memory()) / (1 << 20), peak_memory_mb());
  std::fflush(stdout);
}

Result<SkinnedModel> build(const asset::Asset& asset, std::span<const Matrix4> samples) {
  return build_model(asset.mesh(),
                     {.off_weights = OffWeights::renormalise, .sample_palettes = samples});
}

int fail(const Error& error) {
  std::fprintf(stderr, "crowd_scaling: %s\n", error.message.c_str());
  return 1;
}

int measure_scene(const std::string& path) {
  const Result<scenes::Scene> scene = scenes::load_scene(path);
  if (!scene) return fail(scene.error());
  std::vector<SkinnedModel> models;
  for (const scenes::Character& character : scene->characters) {
    const Result<SkinnedModel> model =
        build(character.asset, WalkPhases(character.asset).samples());
    if (!model) return fail(model.error());
    models.push_back(*model);
  }
  Job job;
  job.frame_count = scene->frame_count;
  for (const scenes::Instance& instance : scene->instances)
    job.models.push_back(models[instance.character]);
  asset::SampleScratch scratch;
  job.pose = [&](std::uint32_t frame, std::vector<Matrix4>& palettes) {
    palettes.clear();
    for (std::uint32_t i = 0; i < scene->instances.size(); ++i) {
      const std::size_t first = palettes.size();
      palettes.resize(first + job.models[i].joint_count());
      instance_palette(*scene, i, frame, scratch, std::span(palettes).subspan(first));
    }
  };
  print_head();
  print_row(job);
  return 0;
}

int measure_character(const scenes::Character& character, double metre) {
  const WalkPhases phases(character.asset);
  const Result<SkinnedModel> model = build(character.asset, phases.samples());
  if (!model) return fail(model.error());
  std::printf("%s, %u triangles, %u joints\n", character.name.c_str(), model->triangle_count(),
              model->joint_count());
  print_head();
  for (const std::uint32_t count : {100u, 1000u, 10000u}) {
    const WalkingCrowd crowd(phases, count, metre);
    Job job;
    job.models.assign(count, *model);
    job.frame_count = 15;
    job.pose = [&](std::uint32_t frame, std::vector<Matrix4>& palettes) {
      crowd.pose(frame, palettes);
    };
    print_row(job);
  }
  return 0;
}

int run(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "";
  if (path.ends_with(".json")) return measure_scene(path);
  const Result<scenes::Character> character =
      path.empty() ? scenes::generate_character({}) : scenes::load_character(path);
  if (!character) return fail(character.error());
  return measure_character(*character, argc > 2 ? std::atof(argv[2]) : path.empty() ? 1.9 : 1.0);
}

}  // namespace
}  // namespace pelt::bench

int main(int argc, char** argv) { return pelt::bench::run(argc, argv); }
