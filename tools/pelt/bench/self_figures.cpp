#include "tools/pelt/bench/self_figures.hpp"

#include <pelt/self.hpp>

#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/scene_poses.hpp"

#include <map>

namespace pelt::tools::bench {
namespace {

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
