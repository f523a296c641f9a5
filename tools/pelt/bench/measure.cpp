#include "tools/pelt/bench/measure.hpp"

#include <pelt/self.hpp>

#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"
#include "tools/pelt/scene/scene_poses.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace pelt::tools::bench {
namespace {

/// Hashes which pairs touch, because the first contact of a pair is unspecified.
class TouchHash {
 public:
  explicit TouchHash(Asked asked) : of_each_(asked == Asked::self) {}

  void add(std::uint32_t frame, std::size_t collider_count, const scene::FrameContacts& found) {
    auto pair = found.pairs.begin();
    for (std::uint32_t a = 0; a < collider_count; ++a) {
      const auto end = of_each_ ? a + 1 : static_cast<std::uint32_t>(collider_count);
      for (std::uint32_t b = of_each_ ? a : a + 1; b < end; ++b) {
        const bool touch = pair != found.pairs.end() && pair->a == a && pair->b == b;
        if (touch) ++pair;
        for (const std::uint32_t value : {frame, a, b, std::uint32_t{touch}}) hash_.add_u32(value);
      }
    }
  }

  std::uint64_t value() const { return hash_.value(); }

 private:
  bool of_each_;
  detail::Fnv1a64 hash_;
};

/// The answer of the frames added so far.
struct AnswerSoFar {
  explicit AnswerSoFar(Asked asked) : touches(asked) {}

  void add(std::uint32_t frame, std::size_t collider_count, const scene::FrameContacts& found) {
    contacts.add(frame, found);
    touches.add(frame, collider_count, found);
    frames_in_contact += !found.contacts.empty();
    contact_count += found.contacts.size();
  }

  Answer to(Question question) const {
    const bool all = question == Question::all;
    return {all ? contacts.value() : touches.value(), work, frames_in_contact, contact_count};
  }

  scene::ContactHash contacts;
  TouchHash touches;
  QueryStats work;
  std::uint64_t frames_in_contact = 0, contact_count = 0;
};

/// The frame before `frame` in an animation. Scenes may loop, so the last frame comes before the
/// first.
std::uint32_t frame_before(std::uint32_t frame, const scenes::Scene& scene) {
  return frame == 0 ? scene.frame_count - 1 : frame - 1;
}

/// Whether a cache is not measured in the frame with this index.
bool is_passed_over(std::size_t index, std::size_t frame_count, const Cache& cache) {
  const std::size_t most = std::min(cache.most_frames, frame_count);
  return index % ((frame_count + most - 1) / most) != 0;
}

/// Measures all methods on all frames.
class Measurement {
 public:
  Measurement(const Subject& subject, std::span<const BenchMethod> methods,
              std::span<const Variant> variants, std::uint32_t repetitions)
      : subject_(subject),
        variants_(variants),
        repetitions_(repetitions),
        time_(time_of(methods)),
        series_(methods.size(), std::vector<Series>(variants.size())) {
    for (const BenchMethod& method : methods) runners_.emplace_back(subject.colliders, method);
  }

  Result<void> run(const std::function<void()>& advance) {
    for (std::size_t i = 0; i < subject_.frames.size(); ++i) {
      const std::uint32_t frame = subject_.frames[i];
      scene::sample_palettes(subject_.scene, frame_before(frame, subject_.scene), scratch_,
                             before_);
      scene::sample_palettes(subject_.scene, frame, scratch_, now_);
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
      if (is_passed_over(index, subject_.frames.size(), variants_[v].cache)) continue;
      const auto time =
          median_time(repetitions_, [&] { return repeat_once(runner, variants_[v]); });
      if (!time) return time.error();
      series_[method][v].add(*time, !runner.found().contacts.empty());
    }
    return {};
  }

  /// Runs one repetition: the previous frame untimed, then this frame.
  Result<FrameTime> repeat_once(Runner& runner, const Variant& variant) {
    const bool update_counts = runner.update_counts();
    if (const auto posed = runner.pose(before_); !posed) return posed.error();
    runner.ask(variant.question);
    if (!update_counts) {
      if (const auto posed = runner.pose(now_); !posed) return posed.error();
    }
    if (variant.cache.prepare) variant.cache.prepare(runner.threads());
    Stopwatch watch(time_);
    if (update_counts) {
      if (const auto posed = runner.pose(now_); !posed) return posed.error();
    }
    watch.lap();
    runner.ask(variant.question);
    watch.stop();
    return FrameTime{watch.microseconds(), watch.lap_microseconds()};
  }

  const Subject& subject_;
  std::span<const Variant> variants_;
  std::uint32_t repetitions_;
  Time time_;
  std::vector<Runner> runners_;
  std::vector<std::vector<Series>> series_;
  asset::SampleScratch scratch_;
  scene::Palettes before_, now_;
};

/// The instances of a scene, queried with or without trackers.
class Player {
 public:
  Player(std::span<const scene::Collider> colliders, const std::vector<SelfFilter>& filters,
         bool has_trackers)
      : filters_(filters), posed_(colliders) {
    if (!has_trackers) return;
    for (const SelfFilter& filter : filters_) trackers_.emplace_back(filter);
  }

  /// Poses and queries all instances, and returns the time.
  Result<double> play(const scene::Palettes& palettes) {
    contacts_.clear();
    Stopwatch watch;
    if (const auto posed = posed_.set_palettes(palettes); !posed) return posed.error();
    for (std::size_t c = 0; c < filters_.size(); ++c) {
      Pose& pose = posed_.poses()[c];
      if (trackers_.empty())
        self_collide(pose, filters_[c], scratch_, contacts_);
      else
        self_collide(pose, trackers_[c], scratch_, contacts_);
    }
    watch.stop();
    return watch.microseconds();
  }

  const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  const std::vector<SelfFilter>& filters_;
  std::vector<SelfTracker> trackers_;
  scene::ScenePoses posed_;
  Scratch scratch_;
  std::vector<Contact> contacts_;
};

/// Times [frames][plays].
using PlayTimes = std::vector<std::vector<double>>;

double mean_of_medians(const PlayTimes& times) {
  std::vector<double> medians;
  for (const std::vector<double>& of_frame : times) medians.push_back(output::median(of_frame));
  return output::mean(medians);
}

/// Plays all frames once with both players.
Result<void> play_both(const Subject& subject, Player& self, Player& tracked, PlayTimes& self_times,
                       PlayTimes& tracked_times) {
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  for (std::size_t f = 0; f < subject.frames.size(); ++f) {
    scene::sample_palettes(subject.scene, subject.frames[f], scratch, palettes);
    const Result<double> without = self.play(palettes);
    if (!without) return in_frame(subject.frames[f], without.error());
    const Result<double> with = tracked.play(palettes);
    if (!with) return in_frame(subject.frames[f], with.error());
    if (self.contacts() != tracked.contacts())
      return in_frame(subject.frames[f],
                      {ErrorCode::invalid_argument,
                       "SelfTracker gives other contacts: please report this with the scene"});
    self_times[f].push_back(*without);
    tracked_times[f].push_back(*with);
  }
  return {};
}

/// Builds the filter of each collider, once for each model, and adds the cost to `figures`.
Result<std::vector<SelfFilter>> build_filters(std::span<const scene::Collider> colliders,
                                              SelfFigures& figures) {
  std::map<const detail::Model*, SelfFilter> built;
  std::vector<SelfFilter> filters;
  for (const scene::Collider& collider : colliders) {
    auto known = built.find(&collider.model.detail());
    if (known == built.end()) {
      Stopwatch watch;
      const Result<SelfFilter> filter = build_self_filter(collider.model);
      watch.stop();
      if (!filter) return filter.error();
      figures.filter_bytes += filter->memory_bytes();
      figures.filter_build_seconds += watch.microseconds() * 1e-6;
      known = built.emplace(&collider.model.detail(), *filter).first;
    }
    filters.push_back(known->second);
  }
  return filters;
}

}  // namespace

const char* name_of(Question question) { return question == Question::all ? "all" : "first"; }

const char* name_of(Asked asked) {
  constexpr std::array kNames = {"pairs", "crowd", "self", "none"};
  return kNames[static_cast<std::size_t>(asked)];
}

const char* name_of(Time time) { return time == Time::thread ? "thread" : "wall"; }

BenchMethod method_of(methods::MethodKind method) {
  return {std::string(method.name), [method](std::span<const scene::Collider> colliders) {
            return scene::SceneQuery(colliders, method.make());
          }};
}

BenchMethod self_method(methods::MethodKind method) {
  const auto make = [method](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::of_each(colliders, method.make());
  };
  return {std::string(method.name), make, method == methods::kBoxes ? Asked::none : Asked::self};
}

BenchMethod crowd_method(std::uint32_t threads) {
  const auto make = [threads](std::span<const scene::Collider> colliders) {
    return scene::SceneQuery::as_crowd(colliders, threads);
  };
  return {std::string(methods::kOnDemand.name), make, Asked::crowd, threads};
}

Time time_of(std::span<const BenchMethod> methods) {
  const bool as_crowd = std::any_of(methods.begin(), methods.end(), [](const BenchMethod& method) {
    return method.asked == Asked::crowd;
  });
  return as_crowd ? Time::wall : Time::thread;
}

Result<std::vector<std::uint32_t>> choose_frames(
    const scenes::Scene& scene, const std::optional<arguments::FrameRange>& chosen) {
  const arguments::FrameRange frames = chosen.value_or(arguments::FrameRange{0, scene.frame_count});
  if (frames.end <= scene.frame_count) return frames.frames();
  return text::bad_argument("--frames", std::to_string(frames.end) + " goes beyond the last frame",
                            scene.name + " has frames 0:" + std::to_string(scene.frame_count));
}

Result<void> require_two_instances(const scenes::Scene& scene, const std::string& alternative) {
  if (scene.instances.size() >= 2) return {};
  return text::bad_argument(text::printable(scene.name),
                            "has " + text::counted(scene.instances.size(), "instance") +
                                ", so there is no pair to measure",
                            "add instances until there are at least two" + alternative);
}

void Runner::ask(Question question) {
  Limits limits;
  if (question == Question::first) limits.max_contacts = 1;
  query_.collide(limits, found_);
}

Error in_frame(std::uint32_t frame, const Error& error) {
  return text::prefixed("frame " + std::to_string(frame), error);
}

Result<std::vector<Answer>> answer(const Subject& subject, const BenchMethod& method,
                                   std::span<const Question> questions) {
  Runner runner(subject.colliders, method);
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  std::vector<AnswerSoFar> answers(questions.size(), AnswerSoFar(method.asked));
  for (const std::uint32_t frame : subject.frames) {
    scene::sample_palettes(subject.scene, frame, scratch, palettes);
    for (std::size_t q = 0; q < questions.size(); ++q) {
      const QueryStats before = runner.work();
      if (const auto posed = runner.pose(palettes); !posed) return in_frame(frame, posed.error());
      runner.ask(questions[q]);
      answers[q].work += scene::work_between(before, runner.work());
      answers[q].add(frame, subject.colliders.size(), runner.found());
    }
  }
  std::vector<Answer> result;
  for (std::size_t q = 0; q < questions.size(); ++q) result.push_back(answers[q].to(questions[q]));
  return result;
}

Result<FrameTime> median_time(std::uint32_t repetitions,
                              const std::function<Result<FrameTime>()>& once) {
  std::vector<double> all, update;
  for (std::uint32_t r = 0; r < repetitions; ++r) {
    const Result<FrameTime> time = once();
    if (!time) return time.error();
    all.push_back(time->all_us);
    update.push_back(time->update_us);
  }
  return FrameTime{output::median(all), output::median(update)};
}

void Series::add(const FrameTime& time, bool is_in_contact) {
  all_.push_back(time.all_us);
  update_.push_back(time.update_us);
  if (is_in_contact) in_contact_.push_back(time.all_us);
}

Times Series::times() const {
  return {output::mean(all_),        output::median(all_),
          output::mean(in_contact_), output::percentile(all_, 0.95),
          output::mean(update_),     all_.size(),
          in_contact_.size()};
}

Result<std::vector<std::vector<Times>>> measure(const Subject& subject,
                                                std::span<const BenchMethod> methods,
                                                std::span<const Variant> variants,
                                                std::uint32_t repetitions,
                                                const std::function<void()>& advance) {
  Measurement measurement(subject, methods, variants, repetitions);
  if (const auto done = measurement.run(advance); !done) return done.error();
  return measurement.times();
}

Result<Skinning> measure_skinning(const Subject& subject, std::uint32_t repetitions) {
  scene::ScenePoses posed(subject.colliders);
  std::vector<std::vector<Vec3>> positions;
  Skinning skinning;
  for (const scene::Collider& collider : subject.colliders) {
    positions.emplace_back(collider.model.vertex_count());
    skinning.vertices += positions.back().size();
  }
  const auto skin_all = [&]() -> Result<FrameTime> {
    Stopwatch watch;
    for (std::size_t c = 0; c < positions.size(); ++c)
      posed_vertices(posed.poses()[c], positions[c]);
    watch.stop();
    return FrameTime{watch.microseconds(), 0};
  };
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  Series frames;
  for (const std::uint32_t frame : subject.frames) {
    scene::sample_palettes(subject.scene, frame, scratch, palettes);
    if (const auto set = posed.set_palettes(palettes); !set) return set.error();
    frames.add(*median_time(repetitions, skin_all), false);
  }
  skinning.mean_us = frames.times().mean_us;
  return skinning;
}

Result<SelfFigures> measure_self(const Subject& subject, std::uint32_t repetitions) {
  SelfFigures figures;
  const auto filters = build_filters(subject.colliders, figures);
  if (!filters) return filters.error();
  Player self(subject.colliders, *filters, false), tracked(subject.colliders, *filters, true);
  PlayTimes self_times, tracked_times;
  for (std::uint32_t play = 0; play <= repetitions; ++play) {
    if (play <= 1) {  // the first play is not timed
      self_times.assign(subject.frames.size(), {});
      tracked_times = self_times;
    }
    const auto played = play_both(subject, self, tracked, self_times, tracked_times);
    if (!played) return played.error();
  }
  figures.self_us = mean_of_medians(self_times);
  figures.tracked_us = mean_of_medians(tracked_times);
  return figures;
}

}  // namespace pelt::tools::bench
